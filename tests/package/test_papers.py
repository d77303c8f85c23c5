"""The papers of the seeds, regenerated: every command of their folders, the values they give."""

import csv
import math
import re
import shlex

import pytest

from mechc.cli import main
from paths import EXAMPLES
from seed_friction import entries

COMMAND = re.compile(r"^mechc (.*)$", re.MULTILINE)
PAPERS = {
    name: COMMAND.findall((EXAMPLES / name / "README.md").read_text("utf-8"))
    for name in ("karpenko-2023", "manzhosov-2019", "fedoriv", "hodunko-2019")
}
EVERY = [(paper, line) for paper, lines in PAPERS.items() for line in lines]


def made(paper, stem, folder):
    """Return the table that the command of a figure writes."""
    line = next(line for line in PAPERS[paper] if f"{stem}.csv" in line)
    assert main(shlex.split(line)) == 0
    with (folder / f"{stem}.csv").open(encoding="utf-8") as file:
        heads, *rows = csv.reader(file)
    columns = zip(*([float(cell) for cell in row] for row in rows), strict=True)
    return dict(zip(heads, columns, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize(("paper", "line"), EVERY)
def test_every_command_writes_its_files(paper, line, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(shlex.split(line)) == 0
    assert capsys.readouterr() == ("", "")
    assert {p.name for p in tmp_path.iterdir()} == set(re.findall(r"-o (\S+)", line))


@pytest.mark.parametrize(
    ("stem", "seed", "varied"),
    [("figure-5", "S000-F5", "alpha"), ("figure-6", "S000-F6", "theta"),
     ("figure-10", "S000-F10", "beta"), ("figure-11", "S000-F11", "beta"),
     ("figure-12", "S000-F12", "alpha")],
)  # fmt: skip
def test_figures_of_karpenko(stem, seed, varied, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    places, values = made("karpenko-2023", stem, tmp_path).values()
    found = dict(zip(places, values, strict=True))
    for point in entries("values.json")[seed]["points"]:
        at = round(math.degrees(point["inputs"][varied]), 9)
        assert found[at] == pytest.approx(point["value"], rel=1e-9, abs=1e-9)


def test_figures_of_manzhosov(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    phi, k = made("manzhosov-2019", "figure-6", tmp_path).values()
    _, gamma, beta = made("manzhosov-2019", "figure-5", tmp_path).values()
    for at, *found in zip(phi, k, gamma, beta, strict=True):
        angle = math.asin(math.sin(at) / 5)
        ratio = (1.2 + 0.2) * math.cos(angle) / math.sin(at + angle)
        folded = min(at + angle, math.pi - at - angle)
        wanted = [ratio, math.degrees(folded), math.degrees(angle)]
        assert found == pytest.approx(wanted, rel=1e-12)
