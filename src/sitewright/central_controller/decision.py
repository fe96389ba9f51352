"""The record of a person's decision: who pressed what, in which role, and which text was seen."""

from __future__ import annotations

from dataclasses import dataclass

NEW_MOTION = "new-motion"
"""Verb of a decision that only wants another motion."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DecisionRecord:
    """What the journal keeps of a decision beside its effect, for the audit.

    Attributes:
        key: Chosen by the client for each press; the same key never decides twice.
        body_sha256: Of the request, to tell a repeated press from a reused key.
        verb: ``approve``, ``reject``, ``instead`` ...
        role: Role in which the person decided.
        session: Id of the person's session.
        language: Of the text that was shown.
        shown: Sentences that the person had before the eyes.
        second: The other person, if a policy asked for two.
    """

    key: str
    body_sha256: str
    verb: str
    role: str
    session: str
    language: str = "en"
    shown: tuple[str, ...] = ()
    second: str = ""
