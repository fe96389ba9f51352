"""Identifiers as distinct types, and where new ones come from."""

from __future__ import annotations

from typing import NewType, Protocol

ComponentId = NewType("ComponentId", str)
"""A component of the building model, or a piece of material for it."""
OperationId = NewType("OperationId", str)
"""An operation (nail, screw, paint ...) of one component; unique in the whole model."""
StackId = NewType("StackId", str)
RobotId = NewType("RobotId", str)
EndEffectorId = NewType("EndEffectorId", str)
StationId = NewType("StationId", str)
StockPlaceId = NewType("StockPlaceId", str)
FixtureId = NewType("FixtureId", str)
ZoneId = NewType("ZoneId", str)
BodyId = NewType("BodyId", str)
"""A rigid body of the planning scene: component, fixture, zone or end effector."""
CommandId = NewType("CommandId", str)
RunId = NewType("RunId", str)


class IdSource(Protocol):
    """Where new ids come from; injected, so that runs can be repeated in tests."""

    def new(self) -> str:
        """Return a fresh id that sorts by creation (UUIDv7 in the product)."""
        ...
