"""The schema that editors use agrees with the reader."""

import json

import pytest
import yaml
from jsonschema_rs import Draft202012Validator, meta

from mechc.data_folders import data
from mechc.diagnostics import Report
from mechc.source import Source
from mechc.syntax import from_yaml
from mechc.syntax.schema import schema, written
from notations import CONSTRUCTS, WHOLE_YAML

VALIDATOR = Draft202012Validator(schema())


def test_the_file_is_current():
    assert (data("grammar") / "mechanism.schema.json").read_text("utf-8") == written()


def test_it_is_a_schema():
    meta.validate(json.loads(written()))


@pytest.mark.parametrize("text", [WHOLE_YAML, *(text for _, text in CONSTRUCTS)])
def test_it_accepts_what_the_reader_accepts(text):
    VALIDATOR.validate(yaml.safe_load(text))


@pytest.mark.parametrize(
    "text",
    [
        "parms: {a: 40 mm}",
        "params: {a: {valu: 40 mm}}",
        "params: {2a: 40 mm}",
        "pivots: [o]",
        "links: {x: [OA]}",
        "sliders: {K: {through: O}}",
        "slots: {B: OCD}",
        "gears: [{O1: r1}]",
        "racks: [{A: O}]",
        "geometry: {A: l}",
        "geometry: {AB: {lenght: l}}",
        "geometry: {AB: [x]}",
        "assembly: {ABC: left}",
        "mirror: {sharing: [K]}",
        "forces: {P: {at: A}}",
        "actuators: {P: {between: [A]}}",
        "springs: {c: {between: [A, B]}}",
        "friction: {A: {f: f}}",
        "friction: {A: {guide: mu, length: s}}",
        "friction: {A: {diameter: d}}",
        "motion: up",
        "title: no mechanism",
        "mechc: 2",
        "require: {a: b}",
    ],
)
def test_both_refuse_what_is_wrong(text):
    assert not VALIDATOR.is_valid(yaml.safe_load(text))
    source = Source("a.yaml", text)
    report = Report(source)
    from_yaml.parse(source, report)
    assert report.diagnostics
