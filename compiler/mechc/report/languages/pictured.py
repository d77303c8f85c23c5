"""What pictures say, with places for names: below them, above bodies, instead of them."""

from collections.abc import Mapping

Words = Mapping[str, str]

EN: Words = {
    "without": "without friction",
    "tightening": "with friction, tightening",
    "releasing": "with friction, releasing",
    "per": "forces per unit of {load}",
    "velocities": "velocities",
    "motion": "motion {number} of {count}",
    "open": "not all forces are known on: {bodies}",
    "scheme": "Kinematic scheme",
    "bodies": "Free bodies",
    "plans": "Plans of velocities and of forces",
    "plot": "{names} against {x}",
    "bodies_of": "Free bodies of {name}",
    "plans_of": "Plans of velocities and of forces of {name}",
    "cut": "Every body cut free, with the forces on it: {heads}.",
    "half_cut": "Every body of one mirrored half cut free, with the forces on it: {heads}.",
}

UK: Words = {
    "without": "без тертя",
    "tightening": "з тертям, прямий хід",
    "releasing": "з тертям, зворотний хід",
    "per": "сили на одиницю {load}",
    "velocities": "швидкості",
    "motion": "рух {number} з {count}",
    "open": "не всі сили відомі: {bodies}",
    "scheme": "Кінематична схема",
    "bodies": "Ланки, звільнені від в’язей",
    "plans": "Плани швидкостей і сил",
    "plot": "Залежність {names} від {x}",
    "bodies_of": "Ланки, звільнені від в’язей: {name}",
    "plans_of": "Плани швидкостей і сил: {name}",
    "cut": "Кожна ланка звільнена від в’язей, з силами, що діють на неї: {heads}.",
    "half_cut": "Кожна ланка однієї дзеркальної половини звільнена від в’язей, з силами, "
    "що діють на неї: {heads}.",
}

RU: Words = {
    "without": "без трения",
    "tightening": "с трением, прямой ход",
    "releasing": "с трением, обратный ход",
    "per": "силы на единицу {load}",
    "velocities": "скорости",
    "motion": "движение {number} из {count}",
    "open": "не все силы известны: {bodies}",
    "scheme": "Кинематическая схема",
    "bodies": "Звенья, освобождённые от связей",
    "plans": "Планы скоростей и сил",
    "plot": "Зависимость {names} от {x}",
    "bodies_of": "Звенья, освобождённые от связей: {name}",
    "plans_of": "Планы скоростей и сил: {name}",
    "cut": "Каждое звено освобождено от связей, с силами, действующими на него: {heads}.",
    "half_cut": "Каждое звено одной зеркальной половины освобождено от связей, с силами, "
    "действующими на него: {heads}.",
}
