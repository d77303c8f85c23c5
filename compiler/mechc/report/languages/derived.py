"""What the sentences of a derivation say of forces and friction, in each language."""

from . import equilibrium

ENGLISH = {
    **equilibrium.ENGLISH,
    "released": "Release of constraints: a constraint is taken away, its reaction becomes a "
    "load, and the powers of all loads add up to zero in the motion that is left.{held}",
    "pivot": "Let the pivot {point} move in the direction {direction} with the velocity "
    "{speed}; {force} is its reaction in this direction.",
    "guide": "Let {point} leave its guide in the direction {direction} with the velocity "
    "{speed}; {force} is the reaction of the guide.",
    "pin": "Let the link {link} part from the pin {point} in the direction {direction} with "
    "the velocity {speed}; {force} is the force between them.",
    "touch": "Let {point} part from the surface that it touches in the direction {direction} "
    "with the velocity {speed}; {force} is the force between them.",
    "rope released": "Let the rope that begins at {point} grow shorter with the velocity "
    "{speed}; {force} is its tension.",
    "idle": "Let the constraint at {point} be released in the direction {direction}: no load "
    "does work then, and this component is zero.",
    "rod": "No load acts on the rod {link} between its pins, so that the force acts along its "
    "line.",
    "smooth": "The force of the guide of {point} is perpendicular to it.",
    "shared": "At {point} the forces of the equal parts across the line of symmetry cancel.",
    "tightening": "The motion is along the arrow of {drive}; friction opposes the sliding in "
    "every joint.",
    "tightening, held back": "The motion is along the arrow of {drive}, which only just holds it "
    "back; friction opposes the sliding in every joint.",
    "releasing": "The motion is against the arrow of {drive}; friction opposes the sliding in "
    "every joint.",
    "releasing, held back": "The motion is against the arrow of {drive}, which only just holds "
    "it back; friction opposes the sliding in every joint.",
    "tightening, the return": "The motion is along the arrow of {drive}: at the values given the "
    "mechanism is self-locking, so that {drive} has to drive it back; friction opposes the sliding "
    "in every joint.",
    "releasing, the return": "The motion is against the arrow of {drive}: at the values given the "
    "mechanism is self-locking, so that {drive} has to drive it back; friction opposes the sliding "
    "in every joint.",
    "releasing, by the load": "{drive} drives, and the motion is against the arrow of {load}; "
    "friction opposes the sliding in every joint.",
    "pin friction": "The friction in a pin is a couple: the force on the pin times the radius "
    "{radius} of the friction circle.",
    "guide friction": "The friction of a guide is its coefficient times the normal force.",
    "rod forces": "{force} is the magnitude of the whole force that a rod passes on from pin to "
    "pin, whether compressive or tensile.",
    "part": "By symmetry one of the equal parts is considered.",
    "unit": "Forces are given per unit of {load}.",
    "unit and drive": "Forces are given per unit of {load}, so that {drive} is {ratio}.",
    "pressed": "The rod {link} is in compression.",
    "pulled": "The rod {link} is in tension.",
    "crossed": "The force in {link} acts along the internal common tangent of the friction "
    "circles at its ends, as it turns the same way on both pins.",
    "outer": "The force in {link} acts along an external common tangent of the friction "
    "circles at its ends, as it turns on its pins in opposite ways.",
    "parallel": "The force in {link} keeps its direction: the external common tangent of equal "
    "friction circles is parallel to it.",
    "single": "The force in {link} goes through the pin at one end and touches the friction "
    "circle at the other.",
    "face": "The whole force {force} of the face on {point}, the normal force with friction, "
    "is turned from the normal by the angle of friction.",
    "moments": "Moments about {point} of the forces on {link}:",
    "turns left": "The link {link} turns counter-clockwise. Moments about {point} (on the right "
    "that of the friction in the pivot):",
    "turns right": "The link {link} turns clockwise. Moments about {point} (on the right that of "
    "the friction in the pivot):",
    "squared": "Squaring gives a quadratic equation:",
    "along": "Forces on {point} along its guide:",
    "along with friction": "Forces on {point} along its guide (on the right its friction):",
    "pin of rods": "Forces on the pin {point}, across each of the rods:",
    "first order": "To first order the joints carry the same forces as without friction. Each "
    "joint with friction adds its coefficient times the force {force} times the sliding velocity, "
    "per unit of the drive’s velocity.",
    "first order, same": "To first order the joints carry the same forces as without friction, "
    "which here gives the same result.",
    "first order, less": "To first order the joints carry the same forces as without friction. "
    "Each joint with friction takes away its coefficient times the force {force} times the "
    "sliding velocity, per unit of the drive’s velocity.",
    "slip of pin": "In a pin the relative angular velocity {turn} takes the place of the sliding "
    "velocity, and the radius of the friction circle that of the coefficient.",
    "slip of face": "On a sliding surface {speed} is the sliding velocity.",
    "rope friction": "Where a rope or band slides around a pulley or drum, the tension on one "
    "side is {ratio} times that on the other, {angle} being the angle of wrap (Euler, Eytelwein).",
    "rope, smaller tension": "{force} is the smaller of the two, which the equilibrium of the "
    "bodies gives; their difference is the friction on the pulley.",
    "rope, mean": "The mean of both tensions counts as the normal force, with the coefficient "
    "{part}.",
    "ropes": "The power of friction is the difference of the tensions times the sliding velocity "
    "{speed}, per unit of the drive’s velocity:",
    "straight": "Each friction force is its coefficient times the normal force {force}, which "
    "itself depends on the friction forces. Its power is this times the sliding velocity {speed}, "
    "per unit of the drive’s velocity:",
    "efficient": "The efficiency is given: the part of the driving power that reaches the load.",
    "powers of friction": "Each joint with friction adds its coefficient times the force {force} "
    "times the sliding velocity, per unit of the drive’s velocity.",
    "pressing": "Each friction force is its coefficient times the normal force {force}, which "
    "itself depends on the friction forces:",
    "added by friction": "The force without friction, and what each friction force adds to it:",
    "part along the rod": "{force} is the component along the rod of {whole}, the whole force that "
    "it passes on, and is positive in tension:",
    "whole of the rod": "The force on {link} at {point} is the whole force that the rod passes on; "
    "its components are:",
    "part along the normal": "{force} is the component along the normal of {whole}, the whole "
    "force on {point}:",
    "across": "Forces on {point} across its guide:",
    "balance": "The force on {link} at {point} balances all other forces on it:",
    "unloaded": "Nothing presses the joints that have friction, so friction changes nothing.",
    "iterated again": "The forces {sizes} follow likewise.",
    "iterated": "Here each friction force depends on the others. With {sizes} the forces at the "
    "joints, {parts} their components without friction and {changes} the changes that all "
    "friction makes in them, {sizes} = {whole}, which Newton’s method solves, starting from the "
    "ideal forces.",
}

UKRAINIAN = {
    **equilibrium.UKRAINIAN,
    "released": "Принцип звільнення від в’язей: в’язь відкидаємо, її реакція стає "
    "навантаженням, і сума потужностей усіх сил у русі, який став можливим, дорівнює "
    "нулю.{held}",
    "pivot": "Нехай шарнір {point} рухається в напрямку {direction} зі швидкістю {speed}; "
    "{force} — його реакція в цьому напрямку.",
    "guide": "Нехай точка {point} сходить зі своєї напрямної в напрямку {direction} зі "
    "швидкістю {speed}; {force} — реакція напрямної.",
    "pin": "Нехай ланка {link} відходить від шарніра {point} у напрямку {direction} зі "
    "швидкістю {speed}; {force} — сила взаємодії між ними.",
    "touch": "Нехай точка {point} відходить від поверхні дотику в напрямку {direction} зі "
    "швидкістю {speed}; {force} — сила взаємодії між ними.",
    "rope released": "Нехай канат, що починається в точці {point}, вкорочується зі "
    "швидкістю {speed}; {force} — його натяг.",
    "idle": "Відкинемо в’язь у точці {point} в напрямку {direction}: жодна сила роботи не "
    "виконує, і ця складова дорівнює нулю.",
    "rod": "Між шарнірами стрижня {link} навантажень немає, тому сила діє вздовж нього.",
    "smooth": "Реакція напрямної точки {point} перпендикулярна до неї.",
    "shared": "У точці {point} сили однакових частин поперек осі симетрії взаємно знищуються.",
    "tightening": "Рух відбувається в напрямку {of_drive:сили|моменту} {drive}; тертя протидіє "
    "ковзанню в кожному з’єднанні.",
    "tightening, held back": "Рух відбувається в напрямку {of_drive:сили|моменту} {drive}, "
    "{of_drive:яка|який} його ледь стримує; тертя протидіє ковзанню в кожному з’єднанні.",
    "releasing": "Рух відбувається проти стрілки {of_drive:сили|моменту} {drive}; тертя протидіє "
    "ковзанню в кожному з’єднанні.",
    "releasing, held back": "Рух відбувається проти стрілки {of_drive:сили|моменту} {drive}, "
    "{of_drive:яка|який} його ледь стримує; тертя протидіє ковзанню в кожному з’єднанні.",
    "tightening, the return": "Рух відбувається в напрямку {of_drive:сили|моменту} {drive}: "
    "за наведених значень механізм самогальмівний, тому у зворотний бік його рухає "
    "{of_drive:сама сила|сам момент} {drive}; тертя протидіє ковзанню в кожному з’єднанні.",
    "releasing, the return": "Рух відбувається проти стрілки {of_drive:сили|моменту} {drive}: "
    "за наведених значень механізм самогальмівний, тому у зворотний бік його рухає "
    "{of_drive:сама сила|сам момент} {drive}; тертя протидіє ковзанню в кожному з’єднанні.",
    "releasing, by the load": "{of_drive:Рушійна сила|Рушійний момент} — {drive}, рух відбувається "
    "проти {of_load:сили|моменту|навантажень} {load}; тертя протидіє ковзанню в кожному з’єднанні.",
    "pin friction": "Тертя в шарнірі зводиться до пари, момент якої дорівнює реакції в шарнірі, "
    "помноженій на радіус {radius} круга тертя.",
    "guide friction": "Сила тертя в напрямній дорівнює коефіцієнту тертя, помноженому на "
    "нормальну силу.",
    "rod forces": "{force} — модуль повної сили, яку стрижень передає від шарніра до шарніра: "
    "у стиснутому — стискальної, у розтягнутому — розтягувальної.",
    "part": "Через симетрію розглядаємо одну з однакових частин.",
    "unit": "Усі сили віднесено до {load}.",
    "unit and drive": "Усі сили віднесено до {load}, тож {drive} — це {ratio}.",
    "pressed": "Стрижень {link} стиснутий.",
    "pulled": "Стрижень {link} розтягнутий.",
    "crossed": "Зусилля в стрижні {link} діє вздовж внутрішньої спільної дотичної до кругів "
    "тертя на його кінцях, оскільки він повертається на обох пальцях в один бік.",
    "outer": "Зусилля в стрижні {link} діє вздовж зовнішньої спільної дотичної до кругів "
    "тертя на його кінцях, оскільки він повертається на пальцях у різні боки.",
    "parallel": "Зусилля в стрижні {link} зберігає свій напрямок: зовнішня спільна дотична до "
    "однакових кругів тертя йому паралельна.",
    "single": "Зусилля в стрижні {link} проходить через вісь шарніра на одному кінці та "
    "дотикається до круга тертя на іншому.",
    "face": "Повна реакція {force} поверхні на {point}, тобто нормальна реакція разом із "
    "силою тертя, відхилена від нормалі на кут тертя.",
    "moments": "Рівняння моментів сил, що діють на ланку {link}, відносно {point}:",
    "turns left": "Ланка {link} повертається проти годинникової стрілки. Рівняння "
    "моментів відносно {point} (у правій частині — момент тертя в шарнірі):",
    "turns right": "Ланка {link} повертається за годинниковою стрілкою. Рівняння "
    "моментів відносно {point} (у правій частині — момент тертя в шарнірі):",
    "squared": "Після піднесення до квадрата маємо квадратне рівняння:",
    "along": "Рівняння рівноваги повзуна {point} у проєкції на напрямну:",
    "along with friction": "Рівняння рівноваги повзуна {point} у проєкції на напрямну (у "
    "правій частині — сила тертя):",
    "pin of rods": "Рівняння рівноваги шарніра {point} у проєкціях на перпендикуляри до стрижнів:",
    "first order": "У першому наближенні з’єднання навантажені так, як без тертя. Кожне "
    "з’єднання з тертям додає добуток коефіцієнта тертя, сили {force} і швидкості ковзання, "
    "віднесеної до швидкості привода.",
    "first order, same": "У першому наближенні з’єднання навантажені так, як без тертя, і це "
    "дає тут той самий результат.",
    "first order, less": "У першому наближенні з’єднання навантажені так, як без тертя. Кожне "
    "з’єднання з тертям віднімає добуток коефіцієнта тертя, сили {force} і швидкості ковзання, "
    "віднесеної до швидкості привода.",
    "slip of pin": "У шарнірі замість швидкості ковзання беремо відносну кутову швидкість "
    "{turn}, а замість коефіцієнта тертя — радіус круга тертя.",
    "slip of face": "На поверхні ковзання {speed} — швидкість ковзання.",
    "rope friction": "Де гнучка ланка ковзає по шківу чи барабану, один її натяг у {ratio} разів "
    "більший за інший (формула Ейлера, {angle} — кут охоплення).",
    "rope, smaller tension": "{force} — менший із двох натягів, його дають умови рівноваги; "
    "сила тертя на шківі дорівнює їхній різниці.",
    "rope, mean": "За нормальну силу беремо середнє обох натягів, її коефіцієнт тертя — {part}.",
    "ropes": "Потужність тертя — добуток різниці натягів на швидкість ковзання {speed}, "
    "віднесену до швидкості привода:",
    "straight": "Кожна сила тертя дорівнює коефіцієнту тертя, помноженому на нормальну силу "
    "{force}, яка сама залежить від сил тертя. Потужність сили тертя — її добуток на швидкість "
    "ковзання {speed}, віднесену до швидкості привода:",
    "efficient": "Коефіцієнт корисної дії задано: така частина рушійної потужності доходить "
    "до навантаження.",
    "powers of friction": "Кожне з’єднання з тертям додає добуток коефіцієнта тертя, сили "
    "{force} і швидкості ковзання, віднесеної до швидкості привода.",
    "pressing": "Кожна сила тертя дорівнює коефіцієнту тертя, помноженому на нормальну силу "
    "{force}, яка сама залежить від сил тертя:",
    "added by friction": "Сила без тертя разом із тим, що додає до неї кожна сила тертя:",
    "part along the rod": "{force} — складова вздовж стрижня повної сили {whole}, яку він передає; "
    "за розтягу вона додатна:",
    "whole of the rod": "Сила, що діє на {link} у точці {point}, — це повна сила, яку передає "
    "стрижень; її складові:",
    "part along the normal": "{force} — складова вздовж нормалі повної реакції {whole}, що діє на "
    "{point}:",
    "across": "Рівняння рівноваги повзуна {point} у проєкції на перпендикуляр до напрямної:",
    "balance": "Сила, що діє на ланку {link} у точці {point}, зрівноважує всі інші сили, "
    "прикладені до неї:",
    "unloaded": "У кінематичних парах, для яких задано тертя, сил тиску немає, тож тертя нічого "
    "не змінює.",
    "iterated again": "Сили {sizes} знаходимо так само.",
    "iterated": "Тут кожна сила тертя залежить від інших. Якщо {sizes} — сили тиску в "
    "шарнірах, {parts} — їхні складові без тертя, а {changes} — те, що змінюють у них усі "
    "сили тертя, то {sizes} = {whole}; цю систему розв’язує метод Ньютона, починаючи з "
    "ідеальних сил.",
}

RUSSIAN = {
    **equilibrium.RUSSIAN,
    "released": "Принцип освобождаемости от связей: связь отбрасываем, её реакция становится "
    "нагрузкой, и сумма мощностей всех сил в движении, которое стало возможным, равна "
    "нулю.{held}",
    "pivot": "Пусть шарнир {point} движется в направлении {direction} со скоростью {speed}; "
    "{force} — его реакция в этом направлении.",
    "guide": "Пусть точка {point} сходит со своей направляющей в направлении {direction} со "
    "скоростью {speed}; {force} — реакция направляющей.",
    "pin": "Пусть звено {link} отходит от шарнира {point} в направлении {direction} со "
    "скоростью {speed}; {force} — сила взаимодействия между ними.",
    "touch": "Пусть точка {point} отходит от поверхности касания в направлении {direction} со "
    "скоростью {speed}; {force} — сила взаимодействия между ними.",
    "rope released": "Пусть канат, который начинается в точке {point}, укорачивается со "
    "скоростью {speed}; {force} — его натяжение.",
    "idle": "Отбросим связь в точке {point} в направлении {direction}: ни одна сила не "
    "совершает работы, и эта составляющая равна нулю.",
    "rod": "Между шарнирами стержня {link} нагрузок нет, поэтому сила действует вдоль него.",
    "smooth": "Реакция направляющей точки {point} перпендикулярна к ней.",
    "shared": "В точке {point} силы одинаковых частей поперёк оси симметрии взаимно уничтожаются.",
    "tightening": "Движение происходит в направлении {of_drive:силы|момента} {drive}; трение "
    "противодействует скольжению в каждом соединении.",
    "tightening, held back": "Движение происходит в направлении {of_drive:силы|момента} {drive}, "
    "{of_drive:которая|который} его едва сдерживает; трение противодействует скольжению в каждом "
    "соединении.",
    "releasing": "Движение происходит против стрелки {of_drive:силы|момента} {drive}; трение "
    "противодействует скольжению в каждом соединении.",
    "releasing, held back": "Движение происходит против стрелки {of_drive:силы|момента} {drive}, "
    "{of_drive:которая|который} его едва сдерживает; трение противодействует скольжению в каждом "
    "соединении.",
    "tightening, the return": "Движение происходит в направлении {of_drive:силы|момента} {drive}: "
    "при приведённых значениях механизм самотормозящий, поэтому в обратную сторону его движет "
    "{of_drive:сама сила|сам момент} {drive}; трение противодействует скольжению в каждом "
    "соединении.",
    "releasing, the return": "Движение происходит против стрелки {of_drive:силы|момента} {drive}: "
    "при приведённых значениях механизм самотормозящий, поэтому в обратную сторону его движет "
    "{of_drive:сама сила|сам момент} {drive}; трение противодействует скольжению в каждом "
    "соединении.",
    "releasing, by the load": "{of_drive:Движущая сила|Движущий момент} — {drive}, движение "
    "происходит против {of_load:силы|момента|нагрузок} {load}; трение противодействует "
    "скольжению в каждом соединении.",
    "pin friction": "Трение в шарнире сводится к паре, момент которой равен реакции в шарнире, "
    "умноженной на радиус {radius} круга трения.",
    "guide friction": "Сила трения в направляющей равна коэффициенту трения, умноженному на "
    "нормальную силу.",
    "rod forces": "{force} — модуль полной силы, которую стержень передаёт от шарнира к шарниру: "
    "в сжатом — сжимающей, в растянутом — растягивающей.",
    "part": "В силу симметрии рассматриваем одну из одинаковых частей.",
    "unit": "Все силы отнесены к {load}.",
    "unit and drive": "Все силы отнесены к {load}, поэтому {drive} — это {ratio}.",
    "pressed": "Стержень {link} сжат.",
    "pulled": "Стержень {link} растянут.",
    "crossed": "Усилие в стержне {link} действует вдоль внутренней общей касательной к кругам "
    "трения на его концах, так как он поворачивается на обоих пальцах в одну сторону.",
    "outer": "Усилие в стержне {link} действует вдоль внешней общей касательной к кругам "
    "трения на его концах, так как он поворачивается на пальцах в разные стороны.",
    "parallel": "Усилие в стержне {link} сохраняет своё направление: внешняя общая "
    "касательная к одинаковым кругам трения ему параллельна.",
    "single": "Усилие в стержне {link} проходит через ось шарнира на одном конце и касается "
    "круга трения на другом.",
    "face": "Полная реакция {force} поверхности на {point}, то есть нормальная реакция вместе "
    "с силой трения, отклонена от нормали на угол трения.",
    "moments": "Уравнение моментов сил, действующих на звено {link}, относительно {point}:",
    "turns left": "Звено {link} поворачивается против часовой стрелки. Уравнение "
    "моментов относительно {point} (в правой части — момент трения в шарнире):",
    "turns right": "Звено {link} поворачивается по часовой стрелке. Уравнение "
    "моментов относительно {point} (в правой части — момент трения в шарнире):",
    "squared": "После возведения в квадрат имеем квадратное уравнение:",
    "along": "Уравнение равновесия ползуна {point} в проекции на направляющую:",
    "along with friction": "Уравнение равновесия ползуна {point} в проекции на направляющую "
    "(в правой части — сила трения):",
    "pin of rods": "Уравнения равновесия шарнира {point} в проекциях на перпендикуляры к стержням:",
    "first order": "В первом приближении соединения нагружены так, как без трения. Каждое "
    "соединение с трением добавляет произведение коэффициента трения, силы {force} и скорости "
    "скольжения, отнесённой к скорости привода.",
    "first order, same": "В первом приближении соединения нагружены так, как без трения, и это "
    "даёт здесь тот же результат.",
    "first order, less": "В первом приближении соединения нагружены так, как без трения. Каждое "
    "соединение с трением вычитает произведение коэффициента трения, силы {force} и скорости "
    "скольжения, отнесённой к скорости привода.",
    "slip of pin": "В шарнире вместо скорости скольжения берём относительную угловую скорость "
    "{turn}, а вместо коэффициента трения — радиус круга трения.",
    "slip of face": "На поверхности скольжения {speed} — скорость скольжения.",
    "rope friction": "Где гибкое звено скользит по шкиву или барабану, одно его натяжение в "
    "{ratio} раз больше другого (формула Эйлера, {angle} — угол обхвата).",
    "rope, smaller tension": "{force} — меньшее из двух натяжений, его дают условия равновесия; "
    "сила трения на шкиве равна их разности.",
    "rope, mean": "За нормальную силу берём среднее обоих натяжений, её коэффициент трения — "
    "{part}.",
    "ropes": "Мощность трения — произведение разности натяжений на скорость скольжения {speed}, "
    "отнесённую к скорости привода:",
    "straight": "Каждая сила трения равна коэффициенту трения, умноженному на нормальную силу "
    "{force}, которая сама зависит от сил трения. Мощность силы трения — её произведение на "
    "скорость скольжения {speed}, отнесённую к скорости привода:",
    "efficient": "Коэффициент полезного действия задан: такая часть движущей мощности доходит "
    "до нагрузки.",
    "powers of friction": "Каждое соединение с трением добавляет произведение коэффициента "
    "трения, силы {force} и скорости скольжения, отнесённой к скорости привода.",
    "pressing": "Каждая сила трения равна коэффициенту трения, умноженному на нормальную силу "
    "{force}, которая сама зависит от сил трения:",
    "added by friction": "Сила без трения вместе с тем, что добавляет к ней каждая сила трения:",
    "part along the rod": "{force} — составляющая вдоль стержня полной силы {whole}, которую он "
    "передаёт; при растяжении она положительна:",
    "whole of the rod": "Сила, действующая на {link} в точке {point}, — это полная сила, которую "
    "передаёт стержень; её составляющие:",
    "part along the normal": "{force} — составляющая вдоль нормали полной реакции {whole}, "
    "действующей на {point}:",
    "across": "Уравнение равновесия ползуна {point} в проекции на перпендикуляр к направляющей:",
    "balance": "Сила, действующая на звено {link} в точке {point}, уравновешивает все остальные "
    "силы, приложенные к нему:",
    "unloaded": "В кинематических парах, для которых задано трение, сил давления нет, поэтому "
    "трение ничего не меняет.",
    "iterated again": "Силы {sizes} находим так же.",
    "iterated": "Здесь каждая сила трения зависит от остальных. Если {sizes} — силы давления "
    "в шарнирах, {parts} — их составляющие без трения, а {changes} — то, что меняют в них все "
    "силы трения, то {sizes} = {whole}; эту систему решает метод Ньютона, начиная с идеальных "
    "сил.",
}
