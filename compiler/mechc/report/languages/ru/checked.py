"""What ``mechc check`` says of a sound description, with places for names and numbers."""

from ....statics import verdict
from ..locale import Words, with_reasons
from .pictured import WORDS as PICTURED

WORDS: Words = with_reasons(
    {
        verdict.NO_VALUE: "уравнение мощностей не даёт конечного значения",
        verdict.NEAR_SINGULAR: "положение почти особое",
        verdict.NO_MORE: "другие положения не удовлетворяют условиям применения",
        verdict.TOO_MUCH: "это требует слишком много вычислений",
        verdict.NO_SPEED: "скорость в знаменателе равна нулю",
        "default": "{value} при заданных значениях",
        "jumps": "скачок от {low} до {high}",
        "where": "где {formula}",
        "solve": "где {names} — решение системы уравнений",
        "presses": "где {names} — сила давления в шарнире: {equation}, метод Ньютона",
        "press": "где {names} — силы давления в шарнирах: {equation}, метод Ньютона",
        "holds": "справедливо, пока {conditions}",
        "independent": "не зависит от {names}",
        "proved": "expect {formula}: доказано",
        "agrees": "expect {formula}: совпадает ({value})",
        "equilibrium": "уравнения равновесия отдельных звеньев дают тот же результат, "
        "{trials}: {count}",
        "used": "{prefix} — механизм {name} при значениях, которые ему здесь заданы",
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
        "drive": "обобщённая координата",
        "stroke": "обобщённая координата, от {low} до {high}",
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
        "agree": "Оба метода дают тот же результат: наибольшее относительное расхождение {error}, "
        "{trials}: {count}.",
        "disagree": "Методы дают разные результаты: наибольшее относительное расхождение {error}, "
        "{trials}: {count}.",
        "trial": "проверок",
        "trials": "проверок",
    },
    PICTURED,
)
