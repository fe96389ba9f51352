"""What clients may send: strict shapes, and nothing beside them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Annotated, Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sitewright.central_controller.ports import Answer, Scope, ScopeKind
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import RobotId
from sitewright.interaction_twin.approvers import REASONS
from sitewright.interaction_twin.decisions import (
    Decision,
    Reply,
    ZoneWish,
    refusal,
    shown_as,
)
from sitewright.interaction_twin.roles import Verb
from sitewright.robot_team.skill import SkillCall

_Text = Annotated[str, Field(max_length=500)]
_Id = Annotated[str, Field(max_length=200)]
_Coordinate = Annotated[float, Field(ge=-1_000.0, le=1_000.0)]
_Edge = Annotated[float, Field(ge=0.01, le=100.0)]
_Key = Annotated[str, Field(min_length=8, max_length=100)]
PIN = r"^([0-9]{4,12})?$"
_Body = TypeVar("_Body", bound=BaseModel)


class _Strict(BaseModel):
    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)


class SignIn(_Strict):
    """``POST /api/session``."""

    token: Annotated[str, Field(min_length=8, max_length=200)]
    user: _Id = ""


class Nothing(_Strict):
    """A body without content, ``{}``."""


class ScopeBody(_Strict):
    """How much is approved."""

    kind: Literal["plan", "until", "step"]
    step: Annotated[int, Field(ge=0, le=10_000)] = 0


class CallBody(_Strict):
    """Another action."""

    skill: _Id
    robot: _Id
    arguments: Annotated[list[_Id], Field(max_length=20)]


class ZoneBody(_Strict):
    """A box to keep out of, or the name of one to take away."""

    center_m: tuple[_Coordinate, _Coordinate, _Coordinate] | None = None
    size_m: tuple[_Edge, _Edge, _Edge] | None = None
    yaw_rad: Annotated[float, Field(ge=-7.0, le=7.0)] = 0.0
    remove: _Id = ""


class DecisionBody(_Strict):
    """``POST /api/decisions``."""

    verb: Literal[
        "approve",
        "reject",
        "instead",
        "new-motion",
        "resume",
        "answer",
        "mismatch",
        "zone",
        "manual",
    ]
    key: _Key
    fingerprint: Annotated[str, Field(pattern=r"^([0-9a-f]{64})?$")] = ""
    next_step: Annotated[int, Field(ge=0, le=10_000)] = 0
    scope: ScopeBody | None = None
    shown: Annotated[list[str], Field(max_length=1_000)] = []
    lang: Annotated[str, Field(pattern=r"^[a-z]{2}$")] = "en"
    comment: _Text = ""
    reason: _Text = ""
    detail: _Text = ""
    step: Annotated[int, Field(ge=0, le=10_000)] = 0
    call: CallBody | None = None
    question_id: _Id = ""
    answer: Literal["done", "not-done", "partial", ""] = ""
    component: _Id = ""
    zone: ZoneBody | None = None
    target: _Id = ""
    effects: Annotated[list[_Id], Field(max_length=200)] = []
    by: _Id = ""
    pin: Annotated[str, Field(pattern=PIN)] = ""


class HoldBody(_Strict):
    """``POST /api/hold``."""

    key: _Key
    reason: _Text = ""


class BadRequestError(Exception):
    """A body that is not taken, with the answer to it."""

    def __init__(self, reply: Reply) -> None:
        self.reply = reply
        super().__init__(str(reply.body.get("message")))


def read_body(kind: type[_Body], raw: bytes) -> _Body:
    """Return a body; what is no JSON, has names twice or other fields is a `BadRequestError`."""
    try:
        json.loads(raw, object_pairs_hook=_once, parse_constant=_no_constant)
    except (ValueError, RecursionError) as error:
        message = f"The body is no JSON that is taken: {error}"
        raise BadRequestError(refusal(400, "json", message)) from error
    try:
        return kind.model_validate_json(raw)
    except ValidationError as error:
        where: list[Json] = [
            {"field": ".".join(map(str, e["loc"])), "message": e["msg"]} for e in error.errors()
        ]
        message = "Some fields are missing, unknown or not as they should be."
        raise BadRequestError(refusal(422, "fields", message, where=where)) from error


def decision_from(body: DecisionBody) -> Decision:
    """Return the decision; one that lacks what its verb needs is a `BadRequestError`."""
    lacking = _lacking(body)
    if lacking:
        where: list[Json] = [{"field": f, "message": f"{body.verb} needs it"} for f in lacking]
        message = f"To {body.verb}, {' and '.join(lacking)} must be given."
        raise BadRequestError(refusal(422, "fields", message, where=where))
    call = body.call
    return Decision(
        verb=Verb(body.verb),
        key=body.key,
        fingerprint=body.fingerprint,
        next_step=body.next_step,
        shown=shown_as(body.shown),
        language=body.lang,
        scope=Scope(ScopeKind(body.scope.kind), body.scope.step) if body.scope else Scope(),
        comment=body.comment,
        reason=body.reason,
        detail=body.detail,
        step=body.step,
        call=SkillCall(call.skill, RobotId(call.robot), tuple(call.arguments)) if call else None,
        question_id=body.question_id,
        answer=Answer(body.answer) if body.answer else None,
        component=body.component,
        zone=_zone(body.zone),
        remove_zone=body.zone.remove if body.zone else "",
        target=body.target,
        effects=tuple(body.effects),
    )


def _zone(body: ZoneBody | None) -> ZoneWish | None:
    if body is None or body.center_m is None or body.size_m is None:
        return None
    return ZoneWish(centre_m=body.center_m, size_m=body.size_m, yaw_rad=body.yaw_rad)


def hold_from(body: HoldBody) -> Decision:
    """Return the decision to hold."""
    return Decision(verb=Verb.HOLD, key=body.key, reason=body.reason)


def _lacking(body: DecisionBody) -> list[str]:
    zone = body.zone
    is_box = zone is not None and zone.center_m is not None and zone.size_m is not None
    is_zone = zone is not None and is_box != bool(zone.remove)
    given: dict[str, dict[str, object]] = {
        "approve": {"fingerprint": body.fingerprint, "scope": body.scope is not None},
        "reject": {"fingerprint": body.fingerprint, "reason": body.reason in REASONS},
        "instead": {"fingerprint": body.fingerprint, "call": body.call is not None},
        "new-motion": {"fingerprint": body.fingerprint, "step": body.step > 0},
        "answer": {"question_id": body.question_id, "answer": body.answer},
        "resume": {},
        "mismatch": {"component": body.component},
        "zone": {"zone": is_zone},
        "manual": {"target": body.target, "effects": body.effects},
    }
    return [name for name, is_there in given[body.verb].items() if not is_there]


def _once(pairs: list[tuple[str, Any]]) -> Mapping[str, Any]:
    found = dict(pairs)
    if len(found) != len(pairs):
        raise ValueError("a name stands twice in one object")
    return found


def _no_constant(name: str) -> Any:  # noqa: ANN401 -- never returns
    raise ValueError(f"{name} is no number")
