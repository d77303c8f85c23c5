"""mechc from Python: the formula, its numbers over a range, and code.

Run it from anywhere: python examples/use_from_python.py
"""

from pathlib import Path

import numpy as np

import mechc

clamp = mechc.load(Path(__file__).with_name("clamp.yaml"))

print(clamp.title)
print("k =", clamp.k)  # a sympy expression

at_default = clamp.evaluate()["k"]  # SI and radians, values of the description
print(f"k at the default pose = {at_default:.6f}")

alpha = np.radians([5, 10, 20, 40])
for degrees, k in zip([5, 10, 20, 40], clamp.evaluate(alpha=alpha)["k"], strict=True):
    print(f"k at alpha = {degrees:2d} deg = {k:.6f}")

a, b = sorted(clamp.k.free_symbols, key=str)[:2]
print("dk/da =", clamp.k.diff(a))

header = clamp.emit_files("c")[1]
print(header.name, "declares", header.text.count("double packet_clamp_k("), "function for k")

try:
    mechc.loads("mechanism m\npivot O\nlink OA\nOA = l @ alhpa\n")
except mechc.MechcError as error:
    print(error.diagnostics[0].code, "and", len(error.diagnostics) - 1, "more")
