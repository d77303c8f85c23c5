"""What sentences about the equilibrium of free bodies say, in each language."""

ENGLISH = {
    "equilibrium": "Each body is in equilibrium under all that acts on it.",
    "equal parts": "By symmetry one of the equal parts is considered; on what they share all of "
    "them act.",
    "force in rod": "{force} is the force in the rod {link}, positive in tension.",
    "force of ground": "{force} and {other} are the components of the force of the ground on "
    "{link} at {point}.",
    "force at pin": "{force} and {other} are the components of the force on {link} at the pin "
    "{point}; the opposite acts on what it is joined to.",
    "force along arm": "{force} and {other} are the components, along {arm} and perpendicular to "
    "it, of the force on {link} at the pin {point}; the opposite acts on what it is joined to.",
    "force of guide": "{force} is the force of the guide on {point}, positive to the left of the "
    "guide’s direction.",
    "force of touch": "{force} is the force of {link} on {point}, along the normal.",
    "force of rim": "{force} is the circumferential force between the wheels on {first} and "
    "{rest}, positive where it turns that on {first} counter-clockwise.",
    "force of rack": "{force} is the force of the gear on {pivot} on the rack at {point}, positive "
    "in the direction of the guide.",
    "force of thread": "{force} is the axial force of the screw {link} on {point}, positive in the "
    "direction of the guide.",
    "force of rope": "{force} is the tension of the rope from {first}.",
    "couple in slot": "{force} is the couple of {rest} on {link}, positive counter-clockwise.",
    "forces along": "Forces on {link} in the direction {direction}:",
    "forces across": "Forces on {link} perpendicular to the rod {rod}:",
    "pin along": "Forces on the pin {point} in the direction {direction}:",
    "pin across": "Forces on the pin {point} perpendicular to the rod {rod}:",
    "made up": "The force on {link} at {point} is the sum of those that act on it there:",
    "made up by ground": "The force of the ground at {point} balances all that acts there:",
    "forces per load": "These forces, divided by {load}:",
    "solved together": "These equations together give",
}

UKRAINIAN = {
    "equilibrium": "Кожне тіло перебуває в рівновазі під дією всіх прикладених до нього сил.",
    "equal parts": "Через симетрію розглядаємо одну з однакових частин; на спільні для них "
    "деталі діють усі частини.",
    "force in rod": "{force} — зусилля в стрижні {link}, додатне при розтягу.",
    "force of ground": "{force} і {other} — складові реакції стояка на ланку {link} у шарнірі "
    "{point}.",
    "force at pin": "{force} і {other} — складові реакції на ланку {link} у шарнірі {point}; на "
    "приєднану до неї ланку діє протилежна реакція.",
    "force along arm": "{force} і {other} — складові реакції на ланку {link} у шарнірі {point} "
    "уздовж {arm} і перпендикулярно до {arm}; на приєднану до неї ланку діє протилежна реакція.",
    "force of guide": "{force} — реакція напрямної в точці {point}, додатна ліворуч від напряму "
    "напрямної.",
    "force of touch": "{force} — сила, з якою {link} діє на {point} уздовж нормалі.",
    "force of rim": "{force} — колова сила між колесами на {first} і {rest}, додатна, якщо "
    "обертає колесо на {first} проти годинникової стрілки.",
    "force of rack": "{force} — сила, з якою колесо на {pivot} діє на рейку в точці {point}, "
    "додатна за напрямом напрямної.",
    "force of thread": "{force} — осьова сила, з якою гвинт {link} діє на {point}, додатна за "
    "напрямом напрямної.",
    "force of rope": "{force} — натяг каната, що йде від {first}.",
    "couple in slot": "{force} — момент, з яким {rest} діє на {link}, додатний проти "
    "годинникової стрілки.",
    "forces along": "Рівняння рівноваги ланки {link} у проєкції на напрям {direction}:",
    "forces across": "Рівняння рівноваги ланки {link} у проєкції на перпендикуляр до стрижня "
    "{rod}:",
    "pin along": "Рівняння рівноваги шарніра {point} у проєкції на напрям {direction}:",
    "pin across": "Рівняння рівноваги шарніра {point} у проєкції на перпендикуляр до стрижня "
    "{rod}:",
    "made up": "Реакція на ланку {link} у шарнірі {point} — сума сил, що діють на неї там:",
    "made up by ground": "Реакція стояка в шарнірі {point} зрівноважує всі сили, що діють там:",
    "forces per load": "Ці сили, поділені на {load}:",
    "solved together": "Розв’язавши ці рівняння разом, маємо",
}

RUSSIAN = {
    "equilibrium": "Каждое тело находится в равновесии под действием всех приложенных к нему сил.",
    "equal parts": "В силу симметрии рассматриваем одну из одинаковых частей; на общие для них "
    "детали действуют все части.",
    "force in rod": "{force} — усилие в стержне {link}, положительное при растяжении.",
    "force of ground": "{force} и {other} — составляющие реакции стойки на звено {link} в шарнире "
    "{point}.",
    "force at pin": "{force} и {other} — составляющие реакции на звено {link} в шарнире {point}; "
    "на присоединённое к нему звено действует противоположная реакция.",
    "force along arm": "{force} и {other} — составляющие реакции на звено {link} в шарнире "
    "{point} вдоль {arm} и перпендикулярно к {arm}; на присоединённое к нему звено действует "
    "противоположная реакция.",
    "force of guide": "{force} — реакция направляющей в точке {point}, положительная влево от "
    "направления направляющей.",
    "force of touch": "{force} — сила, с которой {link} действует на {point} вдоль нормали.",
    "force of rim": "{force} — окружная сила между колёсами на {first} и {rest}, положительная, "
    "если вращает колесо на {first} против часовой стрелки.",
    "force of rack": "{force} — сила, с которой колесо на {pivot} действует на рейку в точке "
    "{point}, положительная по направлению направляющей.",
    "force of thread": "{force} — осевая сила, с которой винт {link} действует на {point}, "
    "положительная по направлению направляющей.",
    "force of rope": "{force} — натяжение каната, идущего от {first}.",
    "couple in slot": "{force} — момент, с которым {rest} действует на {link}, положительный "
    "против часовой стрелки.",
    "forces along": "Уравнение равновесия звена {link} в проекции на направление {direction}:",
    "forces across": "Уравнение равновесия звена {link} в проекции на перпендикуляр к стержню "
    "{rod}:",
    "pin along": "Уравнение равновесия шарнира {point} в проекции на направление {direction}:",
    "pin across": "Уравнение равновесия шарнира {point} в проекции на перпендикуляр к стержню "
    "{rod}:",
    "made up": "Реакция на звено {link} в шарнире {point} — сумма сил, действующих на него там:",
    "made up by ground": "Реакция стойки в шарнире {point} уравновешивает все действующие там "
    "силы:",
    "forces per load": "Эти силы, делённые на {load}:",
    "solved together": "Решив эти уравнения совместно, получаем",
}
