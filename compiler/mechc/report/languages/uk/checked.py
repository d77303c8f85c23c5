"""What ``mechc check`` says of a sound description, with places for names and numbers."""

from ....statics import verdict
from ..locale import Words, with_reasons
from .pictured import WORDS as PICTURED

WORDS: Words = with_reasons(
    {
        verdict.NO_VALUE: "рівняння потужностей не дає скінченного значення",
        verdict.NEAR_SINGULAR: "положення майже особливе",
        verdict.NO_MORE: "інші положення не задовольняють умов застосування",
        verdict.TOO_MUCH: "це потребує забагато обчислень",
        verdict.NO_SPEED: "швидкість у знаменнику дорівнює нулю",
        "default": "{value} за заданих значень",
        "jumps": "стрибок від {low} до {high}",
        "where": "де {formula}",
        "solve": "де {names} — розв’язок системи рівнянь",
        "presses": "де {names} — сила тиску в шарнірі: {equation}, метод Ньютона",
        "press": "де {names} — сили тиску в шарнірах: {equation}, метод Ньютона",
        "holds": "справедливо, доки {conditions}",
        "independent": "не залежить від {names}",
        "proved": "expect {formula}: доведено",
        "agrees": "expect {formula}: збігається ({value})",
        "equilibrium": "рівняння рівноваги окремих ланок дають той самий результат, "
        "{trials}: {count}",
        "used": "{prefix} — механізм {name} за значень, які йому тут задано",
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
        "drive": "узагальнена координата",
        "stroke": "узагальнена координата, від {low} до {high}",
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
        "agree": "Обидва методи дають той самий результат: найбільша відносна розбіжність "
        "{error}, {trials}: {count}.",
        "disagree": "Методи дають різні результати: найбільша відносна розбіжність {error}, "
        "{trials}: {count}.",
        "trial": "перевірок",
        "trials": "перевірок",
    },
    PICTURED,
)
