"""An approval: who said yes to which fingerprint, for how much of it, and for how long."""

from __future__ import annotations

import hashlib
import hmac
from dataclasses import dataclass, replace

from sitewright.central_controller.ports import Scope
from sitewright.foundation.canonical import canonical_json


@dataclass(frozen=True, slots=True, kw_only=True)
class Approval:
    """One "yes", sealed with the installation's key.

    Attributes:
        approval_id: Unique; each of its steps starts once.
        fingerprint: SHA-256 of the proposal that was shown.
        who: Person or policy.
        given_utc_ns: When.
        start_before_utc_ns: Its first step must start before this.
        nonce: Makes two approvals of one plan differ.
        mac: HMAC-SHA256 over all the above, as hex; empty before it is sealed.
    """

    approval_id: str
    fingerprint: str
    scope: Scope
    who: str
    given_utc_ns: int
    start_before_utc_ns: int
    nonce: str
    comment: str = ""
    mac: str = ""


def sealed(approval: Approval, key: bytes) -> Approval:
    """Return the approval with its HMAC."""
    return replace(approval, mac=_mac(approval, key))


def _mac(approval: Approval, key: bytes) -> str:
    text = canonical_json(
        [
            "sitewright-approval/1",
            approval.approval_id,
            approval.fingerprint,
            approval.scope.kind.value,
            approval.scope.step,
            approval.who,
            approval.given_utc_ns,
            approval.start_before_utc_ns,
            approval.nonce,
            approval.comment,
        ]
    )
    return hmac.new(key, text.encode(), hashlib.sha256).hexdigest()


def is_genuine(approval: Approval, key: bytes) -> bool:
    """Return whether the approval was sealed with this key and not changed since."""
    return hmac.compare_digest(_mac(approval, key), approval.mac)
