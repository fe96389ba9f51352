"""A planning problem: one target, generated from the site by grounding every predicate."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from itertools import product

from sitewright.building_model.component import Process
from sitewright.building_model.matching import fits
from sitewright.construction_graph.graph import NOWHERE, TargetNode
from sitewright.construction_graph.queries import material_type, materials
from sitewright.errors import BackendError, BuildingModelError
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.costs import FUNCTIONS
from sitewright.symbolic_planning.domain import Domain, Fact
from sitewright.symbolic_planning.evaluators import EVALUATORS, Evaluator, Truth
from sitewright.symbolic_planning.grounding import GroundAction, ground, objects_by_type
from sitewright.symbolic_planning.problem_text import fact_text, problem_text
from sitewright.symbolic_planning.site_index import (
    FASTENING_PROCESSES,
    FINISHING_PROCESSES,
    SiteIndex,
    index_site,
)
from sitewright.symbolic_planning.site_objects import SiteObject, site_objects
from sitewright.symbolic_planning.site_view import SiteView


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """Everything about one target that a planner, a validator or a narrator asks.

    Facts are in PDDL names; `in_site_ids` turns them round.

    Attributes:
        init: True facts that actions may change.
        static: True facts that no action changes.
        goal: Facts that must be true in the end.
        goal_not: Facts that must be false in the end.
        values: Values of the numeric functions, complete.
        actions: The ground actions that can ever become applicable.
        impossible: Sentences about goals that no skill can reach, found while generating.
        text: The problem as PDDL.
    """

    domain: Domain
    target: ComponentId
    objects: tuple[SiteObject, ...]
    init: frozenset[Fact]
    static: frozenset[Fact]
    goal: frozenset[Fact]
    goal_not: frozenset[Fact]
    values: Mapping[Fact, int]
    actions: tuple[GroundAction, ...]
    impossible: tuple[str, ...]
    site_id_by_name: Mapping[str, str]
    text: str

    @property
    def name_by_site_id(self) -> dict[str, str]:
        """PDDL name of each thing of the site."""
        return {o.site_id: o.name for o in self.objects}

    def in_site_ids(self, fact: Fact) -> Fact:
        """Return a fact with site ids for PDDL names."""
        return _in_site_ids(fact, self.site_id_by_name)

    def call(self, action: GroundAction) -> SkillCall:
        """Return an action as a skill call in site ids."""
        robot, *arguments = (self.site_id_by_name[n] for n in action.arguments)
        return SkillCall(action.name, RobotId(robot), tuple(arguments))

    def action(self, call: SkillCall) -> GroundAction | None:
        """Return the action of a skill call, if it can ever become applicable."""
        return next((a for a in self.actions if self.call(a) == call), None)

    def actions_of(self, lines: Sequence[str]) -> tuple[GroundAction, ...]:
        """Return the actions that the lines of a plan name, ``(grasp r1 m3 s2 e1)``.

        Raises:
            BackendError: A line is no action of this problem.
        """
        by_line = {a.line: a for a in self.actions}
        unknown = [line for line in lines if line not in by_line]
        if unknown:
            raise BackendError(f"Plan line {unknown[0]!r} is no action of this problem.")
        return tuple(by_line[line] for line in lines)


def problem_for(
    domain: Domain, view: SiteView, *, evaluators: Mapping[str, Evaluator] = EVALUATORS
) -> Problem:
    """Return the problem of the view's target: from the site as it is to the target installed.

    Every predicate of the domain is applied to all objects of fitting types. What its evaluator
    finds true now is the initial state; what it wants after the installation is the goal.

    Raises:
        BuildingModelError: The domain lacks a type, or two things have the same id.
    """
    site = index_site(view)
    objects = site_objects(site)
    _check_types_known(domain, objects)
    members = objects_by_type(domain, {o.name: o.type for o in objects})
    names = {o.name: o.site_id for o in objects}
    now, goal, goal_not = _evaluated(domain, members, names, site, evaluators)
    fluents = domain.fluents()
    static = frozenset(f for f in now if f[0] not in fluents)
    impossible = _static_goals(goal, goal_not, static, fluents, names)
    return _problem(
        Problem(
            domain=domain,
            target=view.target,
            objects=objects,
            init=frozenset(now - static),
            static=static,
            goal=frozenset(f for f in goal if f[0] in fluents),
            goal_not=frozenset(f for f in goal_not if f[0] in fluents),
            values=_values(domain, members, names, site),
            actions=(),
            impossible=(*impossible, *_hopeless_operations(site), *_no_piece(site)),
            site_id_by_name=names,
            text="",
        )
    )


def with_state(problem: Problem, state: AbstractSet[Fact]) -> Problem:
    """Return the problem that starts from another state of the same site."""
    return _problem(replace(problem, init=frozenset(state)))


def _problem(draft: Problem) -> Problem:
    members = objects_by_type(draft.domain, {o.name: o.type for o in draft.objects})
    actions = ground(
        draft.domain, members, static=draft.static, init=draft.init, values=draft.values
    )
    text = problem_text(
        name=f"{draft.domain.name}-{draft.name_by_site_id[draft.target]}",
        domain=draft.domain.name,
        objects=draft.objects,
        init=draft.init | draft.static,
        values=draft.values,
        goal=(draft.goal, draft.goal_not),
    )
    return replace(draft, actions=actions, text=text)


def _groundings(types: Sequence[str], members: Mapping[str, Sequence[str]]) -> Iterator[Fact]:
    return product(*(members.get(t, ()) for t in types))


def _evaluated(
    domain: Domain,
    members: Mapping[str, Sequence[str]],
    names: Mapping[str, str],
    site: SiteIndex,
    evaluators: Mapping[str, Evaluator],
) -> tuple[set[Fact], set[Fact], set[Fact]]:
    now: set[Fact] = set()
    goal: set[Fact] = set()
    goal_not: set[Fact] = set()
    for name, schema in domain.predicate_by_name.items():
        evaluator = evaluators[name]
        for arguments in _groundings(schema.types, members):
            ids = tuple(names.get(a, a) for a in arguments)
            if evaluator.now(ids, site) is Truth.TRUE:
                now.add((name, *arguments))
            wanted = evaluator.after(ids, site)
            if wanted is not Truth.ANY:
                (goal if wanted is Truth.TRUE else goal_not).add((name, *arguments))
    return now, goal, goal_not


def _values(
    domain: Domain,
    members: Mapping[str, Sequence[str]],
    names: Mapping[str, str],
    site: SiteIndex,
) -> dict[Fact, int]:
    values: dict[Fact, int] = {}
    for name, schema in domain.function_by_name.items():
        tenths = FUNCTIONS[name].tenths
        if tenths is not None:
            for arguments in _groundings(schema.types, members):
                ids = tuple(names.get(a, a) for a in arguments)
                values[(name, *arguments)] = tenths(ids, site)
    return values


def _static_goals(
    goal: AbstractSet[Fact],
    goal_not: AbstractSet[Fact],
    static: AbstractSet[Fact],
    fluents: AbstractSet[str],
    names: Mapping[str, str],
) -> tuple[str, ...]:
    differs = [f for f in goal if f[0] not in fluents and f not in static]
    holds = [f for f in goal_not if f in static]
    texts = [fact_text(_in_site_ids(f, names)) for f in differs]
    texts += [f"(not {fact_text(_in_site_ids(f, names))})" for f in holds]
    return tuple(
        Sentence("goal needs {fact}, which no skill changes", fact=t) for t in sorted(texts)
    )


def _in_site_ids(fact: Fact, names: Mapping[str, str]) -> Fact:
    return (fact[0], *(names.get(n, n) for n in fact[1:]))


def _hopeless_operations(site: SiteIndex) -> tuple[str, ...]:
    """Say which operations of the targets no built-in skill does, or wait for what is not here."""
    handled = FASTENING_PROCESSES | FINISHING_PROCESSES | {Process.PLACE}
    found: list[str] = []
    if site.view.errand is not None:
        return ()
    for target in site.targets:
        node = site.view.graph.node_by_id.get(target)
        for op in node.operations if isinstance(node, TargetNode) else ():
            if op.process not in handled:
                found.append(
                    Sentence(
                        "operation {operation} of {target} is {process}, which no skill does",
                        operation=op.id,
                        target=target,
                        process=op.process.value,
                    )
                )
            later = [
                b
                for b in op.after
                if b not in site.fasteners and b not in site.view.done_operations
            ]
            found.extend(
                Sentence(
                    "operation {operation} of {target} comes after {other}, which is not done "
                    "and is no fastener of this target",
                    operation=op.id,
                    target=target,
                    other=b,
                )
                for b in later
                if op.process is not Process.PLACE
            )
    return tuple(found)


def _no_piece(site: SiteIndex) -> tuple[str, ...]:
    """Say that nothing can become the target, and where pieces lie that nobody may count on."""
    view = site.view
    node = view.graph.node_by_id.get(view.target)
    is_placed = view.target in view.in_place
    if view.errand is not None or view.candidates or is_placed or not isinstance(node, TargetNode):
        return ()
    lost = [
        n.id
        for n in materials(view.graph)
        if n.place == NOWHERE and fits(material_type(n), node.material_type)
    ]
    none = Sentence("no piece that fits {target} can be taken", target=view.target)
    if not lost:
        return (none,)
    return (
        Sentence("{none}; at no stock place any more: {lost:comma}", none=none, lost=tuple(lost)),
    )


def _check_types_known(domain: Domain, objects: Sequence[SiteObject]) -> None:
    for found in objects:
        if found.type not in domain.parent_by_type:
            known = ", ".join(sorted(domain.parent_by_type))
            raise BuildingModelError(
                f"{domain.file} has no type {found.type!r}, which {found.site_id!r} is; "
                f"known: {known}."
            )
