"""JSON: valid under the shipped schema, exact formulas, no NaN."""

import json
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from jsonschema_rs import Draft202012Validator, meta

from mechc.data_folders import data
from mechc.emit.json.to_json import TARGET, schema_text
from mechc.emit.target import Options
from mechc.formula.tree import (
    PI,
    Call,
    Formula,
    Implicit,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    System,
)
from routine_samples import LIBRARY, SAMPLES, compiled, solved
from sources import in_thirds

SHIPPED = data("grammar") / "result.schema.json"
VALIDATOR = Draft202012Validator(json.loads(SHIPPED.read_text(encoding="utf-8")))


def document(sample: str) -> Any:
    (file,) = TARGET.emit(solved(sample), Options(sample))
    assert file.name == f"{sample}.json"
    return json.loads(file.text, parse_constant=pytest.fail)


def formula_of(tree: Any) -> Formula:
    match tree:
        case {"number": value}:
            return Number(Fraction(value))
        case {"pi": True}:
            return PI
        case {"symbol": name}:
            return Symbol(name)
        case {"sum": terms}:
            return Sum(tuple(map(formula_of, terms)))
        case {"product": factors}:
            return Product(tuple(map(formula_of, factors)))
        case {"power": [base, exponent]}:
            return Power(formula_of(base), formula_of(exponent))
        case {"call": function, "arguments": arguments}:
            return Call(function, tuple(map(formula_of, arguments)))
        case {"solution": unknown, "arguments": arguments}:
            names = zip(tree["outer"], tree["anchor"], strict=True)
            equations = tuple(map(formula_of, tree["equations"]))
            unknowns, start = tuple(tree["unknowns"]), tuple(tree["start"])
            system = System(unknowns, equations, tuple(names), start)
            return Implicit(system, unknowns.index(unknown), tuple(map(formula_of, arguments)))
    raise AssertionError(tree)


def test_the_shipped_schema_is_the_one_the_records_make(request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--update"):
        SHIPPED.write_text(schema_text(), encoding="utf-8", newline="\n")
    meta.validate(json.loads(schema_text()))
    assert SHIPPED.read_text(encoding="utf-8") == schema_text()


@pytest.mark.parametrize("sample", [*SAMPLES, *in_thirds(LIBRARY)])
def test_every_document_is_valid(sample: str) -> None:
    VALIDATOR.validate(document(sample))


@pytest.mark.parametrize(
    ("path", "value"),
    [(("version",), 2), (("results", 0, "kind"), "ratio"), (("referee", "extra"), 1)],
)
def test_the_schema_refuses_what_is_wrong(path: tuple[Any, ...], value: object) -> None:
    found = document("clamp")
    place = found
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = value
    assert not VALIDATOR.is_valid(found)


@pytest.mark.parametrize("sample", SAMPLES)
def test_trees_are_the_formulas(sample: str) -> None:
    results = compiled(sample).derivation.results
    for found, result in zip(document(sample)["results"], results, strict=True):
        assert formula_of(found["formula"]["tree"]) == result.formula
        assert [w["name"] for w in found["where"]] == [w.name for w in result.where]


def test_what_is_not_a_number_is_null() -> None:
    found = document("clamp")
    assert found["referee"]["trials"][0]["statics"] is None
    assert found["results"][0]["value"] == 0.067068


def test_a_parameter_is_in_si_with_its_unit() -> None:
    alpha = document("clamp")["parameters"][2]
    assert (alpha["name"], alpha["dimension"]) == ("alpha", "angle")
    assert (alpha["unit"], alpha["written_in"]) == ("rad", "deg")
    assert alpha["value"] == pytest.approx(0.20943951)
    assert document("chained")["parameters"][4]["formula"]["text"] == "a + b"


def test_golden(golden: Callable[[str, str], None]) -> None:
    golden("code/clamp.json", TARGET.emit(compiled("clamp"), Options("clamp"))[0].text)
