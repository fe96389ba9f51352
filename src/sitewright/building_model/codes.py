"""The codes of problems in building models, cells and projects, each with its meaning."""

from __future__ import annotations

from collections.abc import Mapping

CODES: Mapping[str, str] = {
    "C1": "A fastener reaches less than 30 mm into what it should hold.",
    "C2": "A fastening operation lacks its fastener or what it goes into.",
    "D1": "An id is used twice.",
    "E2": "The file cannot be read.",
    "E4": "The file is cut off.",
    "E5": "The file is not text of its format.",
    "F1": "A component has no support below; it is held until it is fastened.",
    "F2": "A component has no support below and nothing fastens it.",
    "G6": "Geometry is degenerate: no size, flat, or nothing left after its cuts.",
    "I2": "A design holds an as-built record.",
    "K1": "A key is missing, unknown or of the wrong kind.",
    "K2": "A key stands twice in one object.",
    "K3": "A number is NaN, infinite or too large.",
    "L1": "A cell names something that does not exist.",
    "L2": "Values of a cell contradict each other.",
    "L3": "A robot or end effector model is unknown or cannot be read.",
    "M1": "There is no stock for a target.",
    "M2": "The stock for a target is too short or too long.",
    "M3": "The stock for a target has another section.",
    "M4": "A piece of material lies in no stack, or a stack holds what is no material.",
    "N1": "A reference uses a name where an id is needed.",
    "O1": "The model lies far from its origin.",
    "P1": "A reference names a component that does not exist.",
    "P2": "Construction parents or the order of operations form a cycle.",
    "P3": "A construction parent is on a layer that carries nothing.",
    "P4": "The order contradicts the construction parents.",
    "Q1": "A component is too heavy for every handler.",
    "Q2": "No gripper holds a component's section.",
    "Q3": "No tool drives a fastener, or does a process.",
    "Q4": "Something is out of every robot's reach.",
    "Q5": "A stack stands at a stock place that the cell lacks.",
    "Q6": "No robot can do what is needed.",
    "S1": "An operation has no built-in skill.",
    "U2": "Lengths look like another unit.",
}
