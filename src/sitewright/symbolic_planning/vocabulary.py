"""The domain file as data: loading it, and checking it against what Sitewright can evaluate."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path

from sitewright.robot_team.cell import Capability
from sitewright.robot_team.skill import Skill
from sitewright.symbolic_planning.costs import FUNCTIONS
from sitewright.symbolic_planning.domain import ROBOT, Action, Domain, Parameter, Schema
from sitewright.symbolic_planning.domain_reader import read_domain
from sitewright.symbolic_planning.evaluators import EVALUATORS, Evaluator
from sitewright.symbolic_planning.pddl_syntax import PddlError

SKILL_ARGUMENTS: Mapping[str, tuple[str, ...]] = {
    Skill.REACH: ("place",),
    Skill.RETRACT: ("place",),
    Skill.GRASP: ("thing", "stock-place", "gripper"),
    Skill.POSITION: ("thing", "target"),
    Skill.SET_DOWN: ("thing", "stock-place"),
    Skill.RELEASE: ("target",),
    Skill.FASTEN: ("fastener", "target", "tool"),
    Skill.APPLY_FINISH: ("finish", "target", "tool"),
    Skill.CHANGE_END_EFFECTOR: ("end-effector", "end-effector", "tool-station"),
}
"""What the executor of each skill expects after the robot, as types of the built-in domain."""

BUILT_IN = "domain.pddl"
TYPED = "domain_typed.pddl"


def built_in_domain(name: str = BUILT_IN) -> Domain:
    """Return a domain that ships with Sitewright: `BUILT_IN` or `TYPED`."""
    text = files("sitewright.symbolic_planning").joinpath(name).read_text(encoding="utf-8")
    return load_domain(text, file=name)


def domain_at(path: Path | None) -> Domain:
    """Return the domain file of a project, or the built-in one if there is none.

    Raises:
        PddlError: The file is no domain that we can plan with.
    """
    if path is None:
        return built_in_domain()
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise PddlError(path.name, 1, "the file is not UTF-8 text") from error
    return load_domain(text, file=path.name)


def load_domain(
    text: str,
    *,
    file: str = BUILT_IN,
    evaluators: Mapping[str, Evaluator] = EVALUATORS,
    skills: Mapping[str, tuple[str, ...]] = SKILL_ARGUMENTS,
) -> Domain:
    """Return the domain in a text after checking that all its words mean something.

    Args:
        text: Content of the domain file.
        file: Its name, for messages.
        evaluators: Meaning of each predicate that may be used.
        skills: Argument types of each skill that may be used.

    Raises:
        PddlError: Naming the line, the word, and the known ones.
    """
    domain = read_domain(text, file=file)
    for schema in domain.predicate_by_name.values():
        _check_predicate(domain, schema, evaluators)
    for schema in domain.function_by_name.values():
        _check_function(domain, schema)
    for constant in domain.constants:
        _check_constant(domain, constant)
    for action in domain.actions:
        _check_action(domain, action, skills)
    if not domain.actions:
        raise PddlError(file, 1, "the domain has no action")
    return domain


def _check_predicate(domain: Domain, schema: Schema, known: Mapping[str, Evaluator]) -> None:
    if schema.name not in known:
        listed = ", ".join(known)
        raise PddlError(
            domain.file,
            schema.line,
            f"predicate '{schema.name}' has no evaluator; known: {listed}",
        )
    _check_types(domain, schema.name, schema.types, known[schema.name].types, schema.line)


def _check_function(domain: Domain, schema: Schema) -> None:
    if schema.name not in FUNCTIONS:
        listed = ", ".join(FUNCTIONS)
        raise PddlError(
            domain.file, schema.line, f"function '{schema.name}' has no values; known: {listed}"
        )
    _check_types(domain, schema.name, schema.types, FUNCTIONS[schema.name].types, schema.line)


def _check_constant(domain: Domain, constant: Parameter) -> None:
    if constant.type != "skill" or constant.name not in tuple(Capability):
        message = f"constant '{constant.name}' is no capability of a robot"
        known = ", ".join(Capability)
        raise PddlError(domain.file, constant.line, f"{message}; known: {known}")


def _check_action(domain: Domain, action: Action, skills: Mapping[str, tuple[str, ...]]) -> None:
    if action.name not in skills:
        listed = ", ".join(skills)
        raise PddlError(
            domain.file, action.line, f"skill '{action.name}' has no executor; known: {listed}"
        )
    types = tuple(p.type for p in action.parameters)
    if not types or not domain.is_a(types[0], ROBOT):
        raise PddlError(domain.file, action.line, f"action '{action.name}' must name a robot first")
    _check_types(domain, action.name, types[1:], skills[action.name], action.line)


def _check_types(
    domain: Domain, name: str, given: tuple[str, ...], wanted: tuple[str, ...], line: int
) -> None:
    fits = len(given) == len(wanted) and all(
        domain.is_a(g, w) for g, w in zip(given, wanted, strict=True)
    )
    if not fits:
        here, expected = " ".join(given) or "none", " ".join(wanted) or "none"
        raise PddlError(domain.file, line, f"'{name}' is about ({expected}), here about ({here})")
