"""What a report tells of a run: values, filled from the journal's events by `summary.py`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.central_controller.events import AnyEvent
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.interaction_twin.drawing.bars import Bar


@dataclass(frozen=True, slots=True)
class Stamped:
    """An event with wall clock and number of its record; 0 if the number is not known."""

    at_utc_ns: int
    event: AnyEvent
    number: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Decision:
    """What a person or policy said.

    Attributes:
        what: ``approved``, ``rejected``, ``other action``, ``answered`` or ``void``.
        code: Check code of the proposal that it is about.
        detail: Scope, reason or choice in words.
    """

    at_utc_ns: int
    what: str
    who: str
    code: str = ""
    detail: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanRow:
    """One proposal that was made.

    Attributes:
        closest_distance_m: Smallest certified distance of its motions.
        planning_s: Time that it took to make it.
    """

    target: ComponentId
    code: str
    steps: int
    duration_s: float
    closest_distance_m: float | None
    planning_s: float


@dataclass(frozen=True, slots=True, kw_only=True)
class BuiltComponent:
    """One row of the as-built table.

    Attributes:
        status: ``installed``, ``in place``, ``needs rework``, ``refused`` or ``open``.
        position_error_m: Distance of the sensed from the wanted origin, at the end.
        angle_error_rad: Angle between sensed and wanted orientation, at the end.
    """

    target: ComponentId
    status: str
    piece: ComponentId | None = None
    robot: RobotId | None = None
    operations_done: int = 0
    operations_total: int = 0
    position_error_m: float | None = None
    angle_error_rad: float | None = None
    note: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Figures:
    """The numbers by which anyone can check a run.

    Attributes:
        trajectories_total: Motions of all skills that were started.
        trajectories_certified: Of these, certified again on the scene as sensed at their start.
        trajectories_confirmed: Of these, confirmed by the independent engine.
        unallowed_contacts: Distinct (pair, skill) that the cell's contact log holds; None while
            the cell has not told.
        closest_distance_m: Smallest certified distance over pairs that are no declared contacts.
        makespan_s: From the start of the first to the end of the last skill, cell's clock.
        planning_s: Times of ``symbolic``, ``motion``, ``certificate`` and ``total``.
    """

    targets_total: int
    targets_installed: int
    fasteners_total: int
    fasteners_driven: int
    finishes_total: int
    finishes_applied: int
    skills_executed: int
    skills_failed: int
    trajectories_total: int
    trajectories_certified: int
    trajectories_confirmed: int
    unallowed_contacts: int | None
    closest_distance_m: float | None
    worst_pose_error_m: float | None
    worst_pose_error_rad: float | None
    replans: int
    questions_asked: int
    makespan_s: float
    planning_s: Mapping[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotTime:
    """The makespan of a run as one robot spent it; the four times add up to it.

    Attributes:
        holds_s: It had a piece in its gripper while another robot worked.
        waits_s: Another robot worked, and it had nothing.
        still_s: No robot worked.
    """

    robot: RobotId
    works_s: float
    holds_s: float
    waits_s: float
    still_s: float


@dataclass(frozen=True, slots=True, kw_only=True)
class RunSummary:
    """Everything that the report shows of a run.

    Attributes:
        continues: The run before, whose site this one started on; empty if there is none.
        resumed: How often the run was taken up again after a stop.
        spent_s: Wall-clock time of the run by cause, in words.
        robot_times: How each robot spent the makespan.
        planned: What the approved proposals foresaw, on the same axis as `actual`.
        ended: How the run stands: ``complete``, ``finished``, ``held`` or ``open``.
    """

    run: str
    project: str
    started_utc_ns: int
    ended_utc_ns: int
    ended: str
    ending_note: str
    figures: Figures
    continues: str = ""
    resumed: int = 0
    spent_s: Mapping[str, float] = field(default_factory=dict)
    robot_times: tuple[RobotTime, ...] = ()
    planned: tuple[Bar, ...] = ()
    actual: tuple[Bar, ...] = ()
    plans: tuple[PlanRow, ...] = ()
    decisions: tuple[Decision, ...] = ()
    refusals: tuple[RefusalNote, ...] = ()
    deviations: tuple[str, ...] = ()
    built: tuple[BuiltComponent, ...] = ()
    contacts: tuple[tuple[str, str, str], ...] = ()
    hashes: Mapping[str, str] = field(default_factory=dict)
