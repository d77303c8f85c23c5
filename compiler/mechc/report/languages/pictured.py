"""What pictures say, with places for names: below them, above bodies, instead of them."""

from collections.abc import Mapping

Words = Mapping[str, str]

EN: Words = {
    "without": "without friction",
    "tightening": "with friction, tightening",
    "releasing": "with friction, releasing",
    "per": "forces per unit of {load}",
    "ground": "ground",
    "other": "other branches",
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
    "scheme_of": "Kinematic scheme of {name}.",
    "links": "Links",
    "slides": "Sliding bodies",
    "pivots": "Fixed pivots",
    "sliders": "Guided points",
    "loads": "Loads",
    "load_at": "{load} at {point}",
    "load_over": "{load} over {line}",
    "couple_on": "couple {load} on {link}",
    "halves": "Both mirrored halves are shown.",
    "branches": "It is one of {count} equal branches.",
    "open_scale": "Not to scale: nothing gives {names}.",
    "far_centres": "Too far off to be drawn: the instantaneous centres of {links}.",
}

UK: Words = {
    "without": "без тертя",
    "tightening": "з тертям, прямий хід",
    "releasing": "з тертям, зворотний хід",
    "per": "сили на одиницю {load}",
    "ground": "стояк",
    "other": "інші гілки",
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
    "scheme_of": "Кінематична схема: {name}.",
    "links": "Ланки",
    "slides": "Повзуни з кількома точками",
    "pivots": "Нерухомі шарніри",
    "sliders": "Точки в напрямних",
    "loads": "Навантаження",
    "load_at": "{load} у точці {point}",
    "load_over": "{load} на відрізку {line}",
    "couple_on": "момент {load} на ланці {link}",
    "halves": "Показано обидві дзеркальні половини.",
    "branches": "Показано одну з {count} однакових гілок.",
    "open_scale": "Не в масштабі: не задано {names}.",
    "far_centres": "Миттєві центри швидкостей надто далеко, щоб їх показати: {links}.",
    "no forces at the joints balance the loads": "жодні сили в кінематичних парах не "
    "зрівноважують навантажень",
    "a joint stands still at that pose, and rounding tells which way it slips": "у цьому положенні "
    "одна з кінематичних пар нерухома, і напрям ковзання в ній визначає лише округлення",
    "no friction was found that balances at that pose": "не знайдено сил тертя, за яких у цьому "
    "положенні є рівновага",
    "an efficiency does not say where friction acts": "із ККД не видно, де діє тертя",
    "forces with friction do not add up, so every load but one needs a size": "сили з тертям не "
    "додаються, тому кожне навантаження, крім одного, має бути задане",
    "friction is found where one load follows from all the others": "тертя визначається тоді, "
    "коли одне навантаження випливає з усіх інших",
}

RU: Words = {
    "without": "без трения",
    "tightening": "с трением, прямой ход",
    "releasing": "с трением, обратный ход",
    "per": "силы на единицу {load}",
    "ground": "стойка",
    "other": "другие ветви",
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
    "scheme_of": "Кинематическая схема: {name}.",
    "links": "Звенья",
    "slides": "Ползуны с несколькими точками",
    "pivots": "Неподвижные шарниры",
    "sliders": "Точки в направляющих",
    "loads": "Нагрузки",
    "load_at": "{load} в точке {point}",
    "load_over": "{load} на отрезке {line}",
    "couple_on": "момент {load} на звене {link}",
    "halves": "Показаны обе зеркальные половины.",
    "branches": "Показана одна из {count} одинаковых ветвей.",
    "open_scale": "Не в масштабе: не заданы {names}.",
    "far_centres": "Мгновенные центры скоростей слишком далеко, чтобы их показать: {links}.",
    "no forces at the joints balance the loads": "никакие силы в кинематических парах не "
    "уравновешивают нагрузок",
    "a joint stands still at that pose, and rounding tells which way it slips": "в этом положении "
    "одна из кинематических пар неподвижна, и направление скольжения в ней определяет лишь "
    "округление",
    "no friction was found that balances at that pose": "не найдено сил трения, при которых в этом "
    "положении есть равновесие",
    "an efficiency does not say where friction acts": "из КПД не видно, где действует трение",
    "forces with friction do not add up, so every load but one needs a size": "силы с трением не "
    "складываются, поэтому каждая нагрузка, кроме одной, должна быть задана",
    "friction is found where one load follows from all the others": "трение определяется, когда "
    "одна нагрузка следует из всех остальных",
}
