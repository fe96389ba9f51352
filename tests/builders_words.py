"""Labels and proposals of a small frame, for tests of what people read."""

from __future__ import annotations

from collections.abc import Sequence

from sitewright.central_controller.ports import Alternative, ApprovalRequest, RefusalNote
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.interaction_twin.labels import Kind, Label, Labels
from sitewright.robot_team.skill import SkillCall

A, B = RobotId("kr120-a"), RobotId("kr120-b")
STUD = ComponentId("stud-1")

LABELS = Labels(
    {
        A: Label(Kind.ROBOT, A),
        B: Label(Kind.ROBOT, B),
        STUD: Label(Kind.COMPONENT, "Transverse stud 1"),
        "thin.5": Label(Kind.PIECE, "thin.5"),
        "pallet": Label(Kind.STOCK_PLACE, "pallet"),
        "gripper-s": Label(Kind.END_EFFECTOR, "gripper-s"),
        "nailer": Label(Kind.END_EFFECTOR, "nailer"),
        "painter": Label(Kind.END_EFFECTOR, "painter"),
        "tools-b": Label(Kind.STATION, "tools-b"),
        "home-a": Label(Kind.PREPARATION, "home-a"),
        "n1": Label(Kind.OPERATION, "nail 1", of=STUD, process="nail"),
        "n2": Label(Kind.OPERATION, "nail 2", of=STUD, process="nail"),
        "p1": Label(Kind.OPERATION, "face 1", of=STUD, process="paint"),
    }
)


def step(
    number: int,
    call: SkillCall,
    *,
    effects: Sequence[str] = (),
    relies_on: Sequence[str] = (),
    duration_s: float = 2.0,
) -> ProposedStep:
    return ProposedStep(
        number=number,
        call=call,
        params={},
        motions=(),
        duration_s=duration_s,
        effects=tuple(effects),
        relies_on=tuple(relies_on),
    )


CALLS = (
    SkillCall("retract", A, ("home-a",)),
    SkillCall("reach", A, ("pallet",)),
    SkillCall("grasp", A, ("thin.5", "pallet", "gripper-s")),
    SkillCall("retract", A, ("pallet",)),
    SkillCall("reach", A, (STUD,)),
    SkillCall("position", A, ("thin.5", STUD)),
    SkillCall("reach", B, ("n1",)),
    SkillCall("fasten", B, ("n1", STUD, "nailer")),
    SkillCall("retract", B, ("n1",)),
    SkillCall("reach", B, ("n2",)),
    SkillCall("fasten", B, ("n2", STUD, "nailer")),
    SkillCall("release", A, (STUD,)),
)


def proposal() -> Proposal:
    effects = {6: ("(positioned stud-1)", "(not (holding kr120-a thin.5))")}
    relies = {7: ("(positioned stud-1)",), 10: ("(positioned stud-1)",)}
    steps = tuple(
        step(n, call, effects=effects.get(n, ()), relies_on=relies.get(n, ()))
        for n, call in enumerate(CALLS, start=1)
    )
    return Proposal(run="0001-test", target=STUD, steps=steps, site_serial=0, context={})


def request(
    *,
    next_step: int = 1,
    is_single: bool = False,
    alternatives: Sequence[Alternative] = (),
    refusals: Sequence[RefusalNote] = (),
    why: str = "",
    fingerprint: str = "f" * 64,
) -> ApprovalRequest:
    return ApprovalRequest(
        proposal=proposal(),
        fingerprint=fingerprint,
        code="7KQ2-M9TD",
        next_step=next_step,
        is_single=is_single,
        alternatives=lambda: tuple(alternatives),
        refusals=tuple(refusals),
        why=why,
    )
