"""The fingerprint of a proposal: SHA-256 over exactly what will run, and its check code."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from itertools import pairwise

from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.foundation.canonical import Json, canonical_json, sha256_hex
from sitewright.foundation.pose import Pose, Quaternion
from sitewright.planning_twin.motion import Certificate, PlannedMotion
from sitewright.planning_twin.scene import Attachment

_MICRO = 1e6
_NANO = 1e9
_PREFIX = b"sitewright-proposal/1\0"
_CROCKFORD = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
_SCALED = ("_m", "_rad", "_s", "_kg", "_m_s", "_n")


def fingerprint(proposal: Proposal) -> str:
    """Return the SHA-256 of the proposal's content as 64 hex digits.

    Only integers and strings are hashed, so that no number format matters: micrometres,
    microradians, microseconds, quaternions times 1e9 with the first non-zero number positive.
    """
    text = canonical_json(content(proposal))
    return hashlib.sha256(_PREFIX + text.encode()).hexdigest()


def check_code(digest: str) -> str:
    """Return the first 40 bits of a fingerprint for the eye, e.g. ``7KQ2-M9TD``."""
    bits = int(digest[:10], 16)
    letters = "".join(_CROCKFORD[(bits >> shift) & 31] for shift in range(35, -1, -5))
    return f"{letters[:4]}-{letters[4:]}"


def content(proposal: Proposal) -> Json:
    """Return what the fingerprint is made of: integers, strings, lists and objects only."""
    numbers = [step.number for step in proposal.steps]
    return {
        "run": proposal.run,
        "targets": [proposal.target],
        "site_serial": proposal.site_serial,
        "context": dict(proposal.context),
        "before": [[a, b] for a, b in pairwise(numbers)],
        "steps": [_step(step) for step in proposal.steps],
    }


def _step(step: ProposedStep) -> Json:
    return {
        "number": step.number,
        "skill": step.call.skill,
        "robot": step.call.robot,
        "arguments": list(step.call.arguments),
        "params": _integers(step.params),
        "motions": [_motion(m) for m in step.motions],
        "duration_us": round(step.duration_s * _MICRO),
        "relies_on": list(step.relies_on),
        "effects": list(step.effects),
        "contacts": [list(pair) for pair in step.contacts],
    }


def _motion(motion: PlannedMotion) -> Json:
    edits: dict[str, Json] = {b: _placement(p) for b, p in motion.scene_edits.items()}
    return {
        "trajectory": motion.timed.trajectory.sha256(),
        "path": motion.timed.path.sha256(),
        "segment_ends_us": [round(t * _MICRO) for t in motion.timed.segment_ends_s],
        "certificate": _certificate(motion.certificate),
        "agreement": [motion.agreement.engine, motion.agreement.samples],
        "scene_edits": edits,
    }


def _certificate(certificate: Certificate) -> str:
    return sha256_hex(
        canonical_json(
            [
                certificate.scene_revision,
                certificate.path_sha256,
                round(certificate.clearance_m * _MICRO),
                round(certificate.closest_distance_m * _MICRO),
                list(certificate.closest_pair or ()),
                certificate.pairs,
                certificate.engine,
            ]
        )
    )


def _placement(placement: Pose | Attachment) -> Json:
    match placement:
        case Pose():
            return ["world", _pose(placement)]
        case Attachment(robot=robot, tip_T_body=tip_T_body):
            return [robot, _pose(tip_T_body)]


def _pose(pose: Pose) -> Json:
    return [[round(x * _MICRO) for x in pose.position_m], _quaternion(pose.quaternion_wxyz)]


def _quaternion(wxyz: Quaternion) -> Json:
    numbers = [round(x * _NANO) for x in wxyz]
    first = next((n for n in numbers if n), 1)
    return [-n for n in numbers] if first < 0 else list(numbers)


def _integers(value: Json, key: str = "") -> Json:
    """Return parameters as integers and strings; ``#`` marks what is no string by itself."""
    if isinstance(value, Mapping):
        return {k: _integers(v, k) for k, v in value.items()}
    if isinstance(value, str):
        return f"#{value}" if value.startswith("#") else value
    if isinstance(value, Sequence):
        if key.endswith("_wxyz") or key == "wxyz":
            w, x, y, z = (float(v) for v in value if isinstance(v, int | float))
            return _quaternion((w, x, y, z))
        return [_integers(v, key) for v in value]
    return _integer(value, key)


def _integer(value: float | None, key: str) -> Json:
    if value is None:
        return "#none"
    if isinstance(value, bool):
        return "#true" if value else "#false"
    if key.endswith(_SCALED):
        return round(value * _MICRO)
    return value if isinstance(value, int) else f"#{round(value * _MICRO)}u"
