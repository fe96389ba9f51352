"""Metres per unit of Rhino's unit systems, by the names that rhino3dm gives them."""

from __future__ import annotations

from collections.abc import Mapping

_INCH = 0.0254

METRES_PER_RHINO_UNIT: Mapping[str, float] = {
    "Angstroms": 1e-10,
    "Nanometers": 1e-9,
    "Microns": 1e-6,
    "Millimeters": 1e-3,
    "Centimeters": 1e-2,
    "Decimeters": 1e-1,
    "Meters": 1.0,
    "Dekameters": 1e1,
    "Hectometers": 1e2,
    "Kilometers": 1e3,
    "Megameters": 1e6,
    "Gigameters": 1e9,
    "Microinches": 1e-6 * _INCH,
    "Mils": 1e-3 * _INCH,
    "Inches": _INCH,
    "Feet": 12 * _INCH,
    "Yards": 36 * _INCH,
    "Miles": 63360 * _INCH,
    "PrinterPoints": _INCH / 72,
    "PrinterPicas": _INCH / 6,
    "NauticalMiles": 1852.0,
    "AstronomicalUnits": 149597870700.0,
    "LightYears": 9460730472580800.0,
    "Parsecs": 3.0856775814913673e16,
}
"""What is not here (no units, unset, units of the user's own) states no length."""
