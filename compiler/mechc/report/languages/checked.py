"""What ``mechc check`` says of a sound description, with places for names and numbers."""

from . import pictured
from .pictured import TROUBLES, Words

REASONS = (
    "virtual power gives no finite value",
    "the pose is within a hair of singular",
    "no more poses meet the conditions of use",
    "the speed below the line vanishes",
)
"""Why a pose is not judged, beside what leaves its bodies without forces, as statics says it."""


def _with_troubles(own: Words, pictured: Words) -> Words:
    return {**{trouble: pictured[trouble] for trouble in TROUBLES}, **own}


EN: Words = _with_troubles(
    {
        **{reason: reason for reason in REASONS},
        "default": "{value} at the default pose",
        "where": "where {formula}",
        "solve": "where {names} solve",
        "presses": "where {names} presses the joint: {equation} by Newton's method",
        "press": "where {names} press the joints: {equation} by Newton's method",
        "holds": "holds while {conditions}",
        "independent": "does not depend on {names}",
        "proved": "expect {formula}: proved",
        "agrees": "expect {formula}: agrees ({value})",
        "equilibrium": "equilibrium of the free bodies agrees in {count} trials",
        "judged": "{name} was judged at {count} of {poses} poses: {reason}",
        "points": "points",
        "parameters": "parameters",
        "vectors": "vectors",
        "follows": "what follows from them",
        "at": "at {place}",
        "pivot": "pivot {place}",
        "placeless": "without a place",
        "slider": "slider",
        "on": "on {body}",
        "found": "found by a loop",
        "open": "without a value{unit}",
        "drive": "the drive",
        "stroke": "the drive, from {low} to {high}",
        "directionless": "a loop must give its direction",
        "lengthless": "its length is open",
        "from": "from {names}",
        "result": "result",
        "pose": "pose",
        "power": "virtual power",
        "statics": "equilibrium",
        "error": "error",
        "condition": "condition",
        "differs": "disagrees",
        "nothing": "Nothing was tried.",
        "agree": "The two methods agree: worst relative error {error} in {count} {trials}.",
        "disagree": "The two methods disagree: worst relative error {error} in {count} {trials}.",
        "trial": "trial",
        "trials": "trials",
    },
    pictured.EN,
)

UK: Words = _with_troubles(
    {
        "virtual power gives no finite value": "рівняння потужностей не дає скінченного значення",
        "the pose is within a hair of singular": "положення майже особливе",
        "no more poses meet the conditions of use": "інші положення не задовольняють умов "
        "застосування",
        "the speed below the line vanishes": "швидкість у знаменнику дорівнює нулю",
        "default": "{value} за заданих значень",
        "where": "де {formula}",
        "solve": "де {names} — розв’язок системи рівнянь",
        "presses": "де {names} — сила тиску в шарнірі: {equation}, метод Ньютона",
        "press": "де {names} — сили тиску в шарнірах: {equation}, метод Ньютона",
        "holds": "справедливо, доки {conditions}",
        "independent": "не залежить від {names}",
        "proved": "expect {formula}: доведено",
        "agrees": "expect {formula}: збігається ({value})",
        "equilibrium": "рівняння рівноваги окремих ланок дають той самий результат, "
        "перевірок: {count}",
        "judged": "{name}: перевірено положень {count} з {poses}; {reason}",
        "points": "точки",
        "parameters": "параметри",
        "vectors": "вектори",
        "follows": "що з них випливає",
        "at": "у точці {place}",
        "pivot": "нерухомий шарнір {place}",
        "placeless": "без заданого місця",
        "slider": "повзун",
        "on": "на {body}",
        "found": "визначається з контуру",
        "open": "без значення{unit}",
        "drive": "ведуча координата",
        "stroke": "ведуча координата, від {low} до {high}",
        "directionless": "напрям має визначити контур",
        "lengthless": "довжина не задана",
        "from": "з {names}",
        "result": "результат",
        "pose": "положення",
        "power": "потужності",
        "statics": "рівновага",
        "error": "похибка",
        "condition": "обумовленість",
        "differs": "не збігається",
        "nothing": "Нічого не перевірено.",
        "agree": "Обидва методи збігаються: найбільша відносна розбіжність {error}, {trials}: "
        "{count}.",
        "disagree": "Методи розходяться: найбільша відносна розбіжність {error}, {trials}: "
        "{count}.",
        "trial": "перевірок",
        "trials": "перевірок",
    },
    pictured.UK,
)

RU: Words = _with_troubles(
    {
        "virtual power gives no finite value": "уравнение мощностей не даёт конечного значения",
        "the pose is within a hair of singular": "положение почти особое",
        "no more poses meet the conditions of use": "другие положения не удовлетворяют условиям "
        "применения",
        "the speed below the line vanishes": "скорость в знаменателе равна нулю",
        "default": "{value} при заданных значениях",
        "where": "где {formula}",
        "solve": "где {names} — решение системы уравнений",
        "presses": "где {names} — сила давления в шарнире: {equation}, метод Ньютона",
        "press": "где {names} — силы давления в шарнирах: {equation}, метод Ньютона",
        "holds": "справедливо, пока {conditions}",
        "independent": "не зависит от {names}",
        "proved": "expect {formula}: доказано",
        "agrees": "expect {formula}: совпадает ({value})",
        "equilibrium": "уравнения равновесия отдельных звеньев дают тот же результат, проверок: "
        "{count}",
        "judged": "{name}: проверено положений {count} из {poses}; {reason}",
        "points": "точки",
        "parameters": "параметры",
        "vectors": "векторы",
        "follows": "что из них следует",
        "at": "в точке {place}",
        "pivot": "неподвижный шарнир {place}",
        "placeless": "без заданного места",
        "slider": "ползун",
        "on": "на {body}",
        "found": "определяется из контура",
        "open": "без значения{unit}",
        "drive": "ведущая координата",
        "stroke": "ведущая координата, от {low} до {high}",
        "directionless": "направление должен определить контур",
        "lengthless": "длина не задана",
        "from": "из {names}",
        "result": "результат",
        "pose": "положение",
        "power": "мощности",
        "statics": "равновесие",
        "error": "погрешность",
        "condition": "обусловленность",
        "differs": "не совпадает",
        "nothing": "Ничего не проверено.",
        "agree": "Оба метода совпадают: наибольшее относительное расхождение {error}, {trials}: "
        "{count}.",
        "disagree": "Методы расходятся: наибольшее относительное расхождение {error}, {trials}: "
        "{count}.",
        "trial": "проверок",
        "trials": "проверок",
    },
    pictured.RU,
)
