"""What Ukrainian and Russian books have in common: functions in formulas, letters of units."""

FUNCTIONS = {
    "tan": r"\operatorname{tg}",
    "cot": r"\operatorname{ctg}",
    "csc": r"\operatorname{cosec}",
    "atan": r"\operatorname{arctg}",
    "atan2": r"\operatorname{arctg2}",
}

UNITS = {
    "mm": "мм",
    "cm": "см",
    "dm": "дм",
    "m": "м",
    "km": "км",
    "um": "мкм",
    "rad": "рад",
    "mrad": "мрад",
    "N": "Н",
    "kN": "кН",
    "MN": "МН",
    "kgf": "кгс",
    "g": "г",
    "kg": "кг",
    "t": "т",
    "Pa": "Па",
    "kPa": "кПа",
    "MPa": "МПа",
    "GPa": "ГПа",
    "bar": "бар",
    "s": "с",
    "ms": "мс",
    "Hz": "Гц",
    "W": "Вт",
    "kW": "кВт",
    "J": "Дж",
}
