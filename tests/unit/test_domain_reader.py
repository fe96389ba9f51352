# ruff: noqa: E501 (a table of cases)
from __future__ import annotations

import re

import pytest

from sitewright.symbolic_planning.evaluators import EVALUATORS
from sitewright.symbolic_planning.pddl_syntax import PddlError
from sitewright.symbolic_planning.vocabulary import TYPED, built_in_domain, domain_at, load_domain

BUILT_IN = built_in_domain()


def changed(old: str, new: str) -> str:
    assert BUILT_IN.text.count(old) >= 1
    return BUILT_IN.text.replace(old, new, 1)


def line_of(text: str, part: str) -> int:
    return text[: text.index(part)].count("\n") + 1


def test_the_built_in_domain_uses_every_evaluator_and_every_skill() -> None:
    assert set(BUILT_IN.predicate_by_name) == set(EVALUATORS)
    assert [a.name for a in BUILT_IN.actions] == [
        "reach",
        "retract",
        "grasp",
        "position",
        "set-down",
        "release",
        "fasten",
        "apply-finish",
        "change-end-effector",
    ]


def test_the_typed_domain_names_subtypes_in_its_parameters() -> None:
    domain = built_in_domain(TYPED)
    types = {a.name: a.parameters[0].type for a in domain.actions}
    assert types["grasp"] == "handler"
    assert types["fasten"] == "finisher"
    assert types["reach"] == "robot"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("(and (at ?r ?p) (mobile ?r))", "(when (at ?r ?p) (mobile ?r))", "'when' is not supported"),
        ("(and (at ?r ?p) (mobile ?r))", "(or (at ?r ?p) (mobile ?r))", "'or' is not supported"),
        ("(imply (spot-of ?p ?t) (positioned ?t))", "(exists (?x - robot) (at ?x ?p))", "'exists'"),
        ("(spot-of ?p ?t) (positioned ?t)))\n", "(positioned ?t) (spot-of ?p ?t)))\n", "static"),
        ("(mobile ?r))\n", "(mobil ?r))\n", "predicate 'mobil' is not declared"),
        ("(at ?r ?p) (mobile ?r)", "(at ?r ?q) (mobile ?r)", "variable '?q' is not declared"),
        ("(at ?r ?p) (mobile ?r)", "(at ?r) (mobile ?r)", "'at' takes 2 arguments, here it has 1"),
        ("(at ?r ?p) (mobile ?r)", "(at ?p ?r) (mobile ?r)", "'at' wants a robot, but '?p' is a"),
        ("(?r - robot ?p - place)\n", "(?r - robot ?p - plaice)\n", "type 'plaice'"),
        ("(:action reach", "(:action glue", "skill 'glue' has no executor; known: reach, retract"),
        ("(:action retract", "(:action reach", "action 'reach' stands twice"),
        ("(vacant ?p - place)", "(wet ?p - place)(vacant ?p - place)", "'wet' has no evaluator; known"),
        ("(ready ?t - target)", "(ready ?t - place)", "'ready' is about (target), here about (place"),
        ("(:functions\n", "(:functions (glue-time ?r - robot)\n", "function 'glue-time' has no values"),
        (":adl", ":fluents", "requirement ':fluents' is not supported"),
        ("(:functions", "(:derived", "':derived' is not supported"),
        ("retracting grasping", "retracting gluing grasping", "constant 'gluing'"),
        ("handler finisher all-rounder - robot", "handler - handler", "lies above itself"),
        ("thing place", "(either thing) place", "'either' is not supported"),
        ("(increase (total-cost) (reach-time ?r ?p))", "(increase (reach-time ?r ?p) 1)", "increase"),
        ("(:action release\n  :parameters (?r - robot ?t - target)",
         "(:action release\n  :parameters (?t - target ?r - robot)", "must name a robot first"),
    ],
)  # fmt: skip
def test_what_cannot_be_planned_with_is_refused_with_its_line(
    old: str, new: str, message: str
) -> None:
    text = changed(old, new)
    with pytest.raises(PddlError, match=re.escape(message)) as caught:
        load_domain(text, file="mine.pddl")
    assert str(caught.value).startswith(f"mine.pddl:{caught.value.line}: ")


def test_the_line_of_an_unsupported_word_is_exact() -> None:
    text = changed("(mobile ?r))\n  :effect", "\n\n (when (at ?r ?p) (mobile ?r)))\n  :effect")
    with pytest.raises(PddlError) as caught:
        load_domain(text)
    assert caught.value.line == line_of(text, "(when")


def test_an_unknown_predicate_is_named_with_its_line_even_if_unused() -> None:
    text = changed("(vacant ?p - place)", "(vacant ?p - place)\n  (wet ?p - place)")
    with pytest.raises(PddlError, match=f":{line_of(text, '(wet')}: predicate 'wet'"):
        load_domain(text)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the file is empty"),
        ("(define (domain x)", "this '(' is never closed"),
        ("(define (domain x)))", "this ')' closes nothing"),
        ("(define (domain x)) (again)", "and nothing else"),
        ("(domain x)", "expected"),
        ("(define (domain x))", "has no action"),
        ("(" * 100_000, "never closed"),
    ],
)
def test_what_is_no_pddl_is_refused(text: str, message: str) -> None:
    with pytest.raises(PddlError, match=re.escape(message)):
        load_domain(text)


def test_a_file_that_is_not_text_is_refused(tmp_path: object) -> None:
    from pathlib import Path

    path = Path(str(tmp_path)) / "domain.pddl"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(PddlError, match="UTF-8"):
        domain_at(path)


def test_upper_case_and_comments_change_nothing() -> None:
    shouted = "; hello (\n" + BUILT_IN.text.upper()
    domain = load_domain(shouted)
    assert {a.name for a in domain.actions} == {a.name for a in BUILT_IN.actions}
