"""What each step relies on and what it changes: facts in site ids."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.errors import BackendError
from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.evaluators import EVALUATORS, Truth
from sitewright.symbolic_planning.grounding import GroundAction
from sitewright.symbolic_planning.problem import Problem
from sitewright.symbolic_planning.problem_text import fact_text
from sitewright.symbolic_planning.site_index import index_site
from sitewright.symbolic_planning.site_view import SiteView

_NOT = "(not "


def relies_on(problem: Problem, action: GroundAction) -> tuple[str, ...]:
    """Return the state facts that must hold when an action starts, as PDDL text in site ids."""
    return _texts(problem, action.needs, action.needs_not)


def effects(problem: Problem, action: GroundAction) -> tuple[str, ...]:
    """Return what an action makes true, and false as ``(not (...))``."""
    return _texts(problem, action.adds, action.deletes - action.adds)


def _texts(problem: Problem, true: Iterable[Fact], false: Iterable[Fact]) -> tuple[str, ...]:
    yes = sorted(fact_text(problem.in_site_ids(f)) for f in true)
    no = sorted(f"{_NOT}{fact_text(problem.in_site_ids(f))})" for f in false)
    return (*yes, *no)


def facts_that_fail(facts: Iterable[str], view: SiteView) -> tuple[str, ...]:
    """Return those of a step's facts that do not hold on the site as it is.

    Args:
        facts: As `relies_on` wrote them.
        view: The site now.

    Raises:
        BackendError: A text is no fact.
    """
    site = index_site(view)
    failing = []
    for text in facts:
        is_negative = text.startswith(_NOT)
        words = text.removeprefix(_NOT).strip("()").split()
        if not words or words[0] not in EVALUATORS:
            raise BackendError(f"{text!r} is no fact that can be evaluated.")
        is_true = EVALUATORS[words[0]].now(tuple(words[1:]), site) is Truth.TRUE
        if is_true == is_negative:
            failing.append(text)
    return tuple(failing)
