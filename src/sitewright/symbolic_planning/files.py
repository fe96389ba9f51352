"""The PDDL of a target for the run folder, so that anyone can check it with any planner."""

from __future__ import annotations

import re
from pathlib import Path

from sitewright.symbolic_planning.planner import NoPlan, SkillSequence
from sitewright.symbolic_planning.problem import Problem


def pddl_texts(problem: Problem, plan: SkillSequence | NoPlan) -> dict[str, str]:
    """Return the texts ``domain``, ``problem`` and ``plan``; a "no" is a comment."""
    match plan:
        case SkillSequence(text=text):
            answer = text
        case NoPlan(is_proven=is_proven, reason=reason):
            answer = f"; {'proven' if is_proven else 'gave up'}: {' '.join(reason.split())}\n"
    return {"domain": problem.domain.text, "problem": problem.text, "plan": answer}


def write_pddl_files(
    folder: Path, problem: Problem, plan: SkillSequence | NoPlan, *, number: int = 1
) -> tuple[Path, ...]:
    """Write ``<target>-<number>.domain``, ``.problem`` and ``.plan``; return their paths.

    Args:
        folder: Made if it is not there.
        problem: What was planned.
        plan: What came of it.
        number: Counts the plans of one target.
    """
    folder.mkdir(parents=True, exist_ok=True)
    stem = f"{re.sub(r'[^A-Za-z0-9._-]', '_', problem.target)}-{number}"
    paths = []
    for suffix, text in pddl_texts(problem, plan).items():
        path = folder / f"{stem}.{suffix}"
        path.write_text(text, encoding="utf-8")
        paths.append(path)
    return tuple(paths)
