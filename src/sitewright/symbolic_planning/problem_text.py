"""Writer of PDDL problems: sorted, so that the same site gives the same bytes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet

from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.site_objects import SiteObject


def problem_text(
    *,
    name: str,
    domain: str,
    objects: Sequence[SiteObject],
    init: AbstractSet[Fact],
    values: Mapping[Fact, int],
    goal: tuple[AbstractSet[Fact], AbstractSet[Fact]],
) -> str:
    """Return a problem as PDDL.

    Args:
        name: Of the problem.
        domain: Name of its domain.
        objects: Site ids and labels are written as comments.
        init: All true facts.
        values: Values of the numeric functions.
        goal: Facts to be made true, and facts to be made false.
    """
    true, false = goal
    wanted = [fact_text(f) for f in sorted(true)] + [f"(not {fact_text(f)})" for f in sorted(false)]
    return "\n".join(
        [
            f"(define (problem {name})",
            f"(:domain {domain})",
            "(:objects",
            *(_object_line(o) for o in objects),
            ")",
            "(:init",
            *_indented(fact_text(f) for f in sorted(init)),
            "  (= (total-cost) 0)",
            *_indented(f"(= {fact_text(f)} {value})" for f, value in sorted(values.items())),
            ")",
            "(:goal (and",
            *_indented(wanted),
            "))",
            "(:metric minimize (total-cost)))",
            "",
        ]
    )


def fact_text(fact: Fact) -> str:
    """Return a fact in brackets."""
    return f"({' '.join(fact)})"


def _indented(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]


def _object_line(found: SiteObject) -> str:
    comment = " ".join(f"{found.site_id} {found.label}".split())
    return f"  {found.name} - {found.type} ; {comment}"
