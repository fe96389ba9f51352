"""Construction order from the tasks of an IFC file: sequences first, planned starts second."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from typing import Any

_ACTUAL = "ACTUAL"


def construction_order(file: Any) -> tuple[dict[str, int], list[str]]:  # noqa: ANN401
    """Return order numbers by GlobalId, equal ones may go parallel, and what was wrong.

    Tasks of schedules that tell what was done (``ACTUAL``) are no design and do not count.
    """
    tasks = {t.id(): t for t in file.by_type("IfcTask")}
    for schedule in file.by_type("IfcWorkControl"):
        if _is_actual(schedule):
            for done in _tasks_under(_controlled(schedule)):
                tasks.pop(done, None)
    products = {i: p for i, t in tasks.items() if (p := _products(t))}
    successors = _sequences(file, tasks)
    if successors:
        rank, has_cycle = _levels(tasks, successors)
    else:
        rank, has_cycle = _by_start(tasks[i] for i in products), False
    notes = ["The sequence of its tasks has a cycle; no order is taken from it."] * has_cycle
    order: dict[str, int] = {}
    for task, ids in products.items():
        for identity in ids if task in rank else ():
            order[identity] = max(rank[task], order.get(identity, 0))
    return _dense(order), notes


def _is_actual(schedule: Any) -> bool:  # noqa: ANN401
    kind = getattr(schedule, "PredefinedType", None) or getattr(schedule, "WorkControlType", None)
    return kind == _ACTUAL


def _controlled(schedule: Any) -> list[Any]:  # noqa: ANN401
    return [o for r in schedule.Controls for o in r.RelatedObjects if o.is_a("IfcTask")]


def _children(task: Any) -> list[Any]:  # noqa: ANN401
    relations = [*getattr(task, "IsNestedBy", ()), *task.IsDecomposedBy]
    return [o for r in relations for o in r.RelatedObjects if o.is_a("IfcTask")]


def _tasks_under(roots: Iterable[Any]) -> set[int]:
    found: set[int] = set()
    waiting = list(roots)
    while waiting:
        task = waiting.pop()
        if task.id() not in found:
            found.add(task.id())
            waiting += _children(task)
    return found


def _products(task: Any) -> list[str]:  # noqa: ANN401
    """Return GlobalIds of what the task builds: its outputs, and what it operates on."""
    outputs = [
        r.RelatingProduct
        for r in task.HasAssignments
        if r.is_a("IfcRelAssignsToProduct") and r.RelatingProduct is not None
    ]
    inputs = [o for r in task.OperatesOn for o in r.RelatedObjects]
    return [o.GlobalId for o in (*outputs, *inputs) if o.is_a("IfcProduct")]


def _sequences(file: Any, tasks: Mapping[int, Any]) -> dict[int, set[int]]:  # noqa: ANN401
    """Return successors by task; a sequence of parents holds for everything below them."""
    successors: dict[int, set[int]] = defaultdict(set)
    for relation in file.by_type("IfcRelSequence"):
        before, after = relation.RelatingProcess, relation.RelatedProcess
        if before.id() not in tasks or after.id() not in tasks:
            continue
        for task in _tasks_under([before]):
            successors[task] |= _tasks_under([after])
    return successors


def _levels(
    tasks: Mapping[int, Any], successors: Mapping[int, set[int]]
) -> tuple[dict[int, int], bool]:
    """Return the longest chain before each task, and whether some go round in a circle."""
    open_before = dict.fromkeys(tasks, 0)
    for later in successors.values():
        for task in later & tasks.keys():
            open_before[task] += 1
    level = dict.fromkeys(tasks, 0)
    waiting = [t for t, n in open_before.items() if n == 0]
    done = 0
    while waiting:
        task = waiting.pop()
        done += 1
        for after in successors.get(task, set()) & tasks.keys():
            level[after] = max(level[after], level[task] + 1)
            open_before[after] -= 1
            if open_before[after] == 0:
                waiting.append(after)
    has_cycle = done < len(tasks)
    return ({} if has_cycle else level), has_cycle


def _by_start(tasks: Iterable[Any]) -> dict[int, int]:
    start = {}
    for task in tasks:
        time = getattr(task, "TaskTime", None)
        if time is not None and time.ScheduleStart:
            start[task.id()] = str(time.ScheduleStart)
    number = {s: n for n, s in enumerate(sorted(set(start.values())))}
    return {task: number[s] for task, s in start.items()}


def _dense(order: Mapping[str, int]) -> dict[str, int]:
    """Return the same order counted 1, 2, 3 ..."""
    number = {value: n for n, value in enumerate(sorted(set(order.values())), start=1)}
    return {identity: number[value] for identity, value in order.items()}
