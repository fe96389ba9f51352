"""The simulated cell as a process: it outlives its clients, and its log outlives it."""

from __future__ import annotations

import json
import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from threading import Thread

import psutil
import pytest

import builders_cell as site
from builders_cell import GRIPPER, A, B, Mover, command, grasp_pose, over
from sitewright.errors import BackendError, CommandRefusedError, OutcomeUnknownError
from sitewright.foundation.ids import CommandId, ComponentId
from sitewright.foundation.pose import translation
from sitewright.robot_team.driver import CellDriver, CommandState
from sitewright.robot_team.drivers.mujoco.cell_log import LOG_NAME, read_physical_log, read_records
from sitewright.robot_team.drivers.mujoco.client import MujocoCell, connect
from sitewright.robot_team.drivers.mujoco.places import PID_NAME, socket_path
from sitewright.robot_team.piece import Piece

THIN = ComponentId("thin-4")


@pytest.fixture
def folder(tmp_path: Path) -> Iterator[Path]:
    yield tmp_path
    pid = pid_of(tmp_path)
    if pid is not None:
        os.kill(pid, signal.SIGKILL)


def pid_of(folder: Path) -> int | None:
    file = folder / PID_NAME
    pid = int(json.loads(file.read_text())["pid"]) if file.exists() else None
    return pid if pid is not None and is_alive(pid) else None


def is_alive(pid: int) -> bool:
    try:
        return bool(psutil.Process(pid).status() != psutil.STATUS_ZOMBIE)
    except psutil.NoSuchProcess:
        return False


def open_cell(
    folder: Path, pieces: tuple[Piece, ...] = site.pieces(), **options: float
) -> MujocoCell:
    return connect(folder, site.cell(), pieces, **options)  # type: ignore[arg-type]


def kill(folder: Path) -> None:
    pid = pid_of(folder)
    assert pid is not None
    os.kill(pid, signal.SIGKILL)
    while is_alive(pid):
        time.sleep(0.005)


def pick(driver: CellDriver, mover: Mover, epoch: int = 1) -> None:
    at = grasp_pose(driver.observe().world_T_piece[THIN])
    reach = command("reach", A, mover.to_tcp(A, GRIPPER, over(at, 0.3), at), epoch=epoch)
    assert driver.execute(reach).is_done
    grasp = command("grasp", A, piece=THIN, width_m=0.09, tolerance_m=0.002, epoch=epoch)
    assert driver.execute(grasp).is_done


def test_a_known_command_returns_its_outcome_and_moves_nothing(folder: Path) -> None:
    driver = open_cell(folder)
    mover = Mover(site.cell())
    order = command("reach", A, mover.through(A, (0.4, *site.HOME[1:])))
    assert driver.status(order.command_id).state is CommandState.NEVER
    first = driver.execute(order)
    assert first.is_done
    seen = driver.observe()
    assert seen.robots[A].q_rad[0] == pytest.approx(0.4, abs=1e-3)
    assert driver.execute(order) == first
    assert driver.observe() == seen
    status = driver.status(order.command_id)
    assert (status.state, status.report) == (CommandState.ENDED, first)
    driver.close()


def test_an_old_epoch_is_refused_and_not_in_the_ledger(folder: Path) -> None:
    driver = open_cell(folder)
    assert (driver.new_epoch(), driver.new_epoch()) == (1, 2)
    order = command("reach", A, Mover(site.cell()).through(A, (0.4, *site.HOME[1:])), epoch=1)
    before = driver.observe()
    with pytest.raises(CommandRefusedError, match="epoch 1 is over"):
        driver.execute(order)
    assert driver.status(order.command_id).state is CommandState.NEVER
    assert driver.observe() == before
    driver.close()


def test_the_process_outlives_its_client_and_is_found_again(folder: Path) -> None:
    first = open_cell(folder)
    pid = pid_of(folder)
    pick(first, Mover(site.cell()))
    seen = first.observe()
    first.close()
    second = open_cell(folder)
    assert pid_of(folder) == pid
    assert second.observe() == seen
    assert seen.robots[A].gripped == THIN
    second.close()


def test_two_clients_share_one_process(folder: Path) -> None:
    cells = [open_cell(folder) for _ in range(2)]
    assert cells[0].new_epoch() == 1
    assert cells[1].new_epoch() == 2
    for driver in cells:
        driver.close()


def test_killed_between_commands_it_goes_on_from_its_log(folder: Path) -> None:
    driver = open_cell(folder)
    epoch = driver.new_epoch()
    pick(driver, Mover(site.cell()), epoch)
    seen = driver.observe()
    kill(folder)
    with pytest.raises(BackendError):
        driver.observe()
    driver.close()
    again = open_cell(folder)
    assert again.observe() == seen
    assert again.new_epoch() == epoch + 1
    assert [e["effect"] for e in read_physical_log(folder / LOG_NAME)] == ["gripped"]
    again.close()


def test_killed_during_a_command_it_says_accepted_and_never_ended(folder: Path) -> None:
    driver = open_cell(folder, real_time_factor=1.0)
    mover = Mover(site.cell())
    order = command("reach", A, mover.through(A, (1.5, *site.HOME[1:])))
    start = driver.observe()
    watcher = open_cell(folder, real_time_factor=1.0)
    states: list[CommandState] = []

    def kill_on_the_way() -> None:
        while watcher.status(order.command_id).state is CommandState.NEVER:
            time.sleep(0.01)
        states.append(watcher.status(order.command_id).state)
        kill(folder)

    thread = Thread(target=kill_on_the_way)
    thread.start()
    with pytest.raises(OutcomeUnknownError):
        driver.execute(order)
    thread.join()
    driver.close()
    watcher.close()
    again = open_cell(folder)
    assert states == [CommandState.RUNNING]
    assert again.status(order.command_id).state is CommandState.ACCEPTED
    with pytest.raises(OutcomeUnknownError):
        again.execute(order)
    assert again.observe().robots == start.robots
    again.close()


def test_a_client_that_dies_does_not_stop_the_motion(folder: Path) -> None:
    first = open_cell(folder)
    order = command("reach", A, Mover(site.cell()).through(A, (1.0, *site.HOME[1:])))
    Thread(target=_execute_and_forget, args=(first, order), daemon=True).start()
    second = open_cell(folder)
    while second.status(order.command_id).state is CommandState.NEVER:
        time.sleep(0.005)
    first._socket.shutdown(2)
    report = second.execute(order)
    first.close()
    assert report.is_done
    assert second.observe().robots[A].q_rad[0] == pytest.approx(1.0, abs=1e-3)
    assert len([r for r in read_records(folder / LOG_NAME)[0] if r["kind"] == "accepted"]) == 1
    second.close()


def _execute_and_forget(driver: MujocoCell, order: object) -> None:
    try:
        driver.execute(order)  # type: ignore[arg-type]
    except BackendError:
        return


@pytest.mark.parametrize("wait_s", [0.0, 0.1, 0.22, 0.3, 0.42])
def test_killed_while_nailing_log_and_wood_agree(folder: Path, wait_s: float) -> None:
    placed = site.piece("thin", site.THIN, site.TARGET)
    pieces = (*site.pieces()[:2], placed)
    driver = open_cell(folder, pieces, real_time_factor=1.0)
    top = translation(0.62, 0.02, site.TARGET.position_m[2] + 0.02) @ site.DOWN
    reach = command("reach", B, Mover(site.cell()).to_tcp(B, site.NAILER, over(top, 0.1), top))
    assert driver.execute(reach).is_done
    fasten = command(
        "fasten",
        B,
        operation="n1",
        through="thin",
        into="support-2",
        fastener={"type": "nail", "d_m": 0.0031, "l_m": 0.09},
        penetration_m=0.03,
    )
    watcher = open_cell(folder, pieces, real_time_factor=1.0)
    thread = Thread(target=_execute_and_forget, args=(driver, fasten))
    thread.start()
    while watcher.status(fasten.command_id).state is CommandState.NEVER:
        time.sleep(0.002)
    time.sleep(wait_s)
    kill(folder)
    thread.join()
    driver.close()
    watcher.close()
    again = open_cell(folder, pieces)
    driven = [e for e in read_physical_log(folder / LOG_NAME) if e["effect"] == "fastener"]
    assert [f.operation for f in again.observe().fasteners] == [e["operation"] for e in driven]
    if again.status(fasten.command_id).state is CommandState.ENDED:
        assert len(driven) == 1
    again.close()


def test_hold_stops_a_running_command(folder: Path) -> None:
    driver = open_cell(folder, real_time_factor=1.0)
    order = command("reach", A, Mover(site.cell()).through(A, (1.5, *site.HOME[1:])))
    holder = open_cell(folder, real_time_factor=1.0)

    def hold() -> None:
        while holder.status(order.command_id).state is not CommandState.RUNNING:
            time.sleep(0.01)
        time.sleep(0.3)
        holder.hold()

    thread = Thread(target=hold)
    thread.start()
    report = driver.execute(order)
    thread.join()
    assert (report.is_done, report.reason) == (False, "held")
    assert driver.observe().robots[A].q_rad[0] < 1.4
    driver.close()
    holder.close()


def test_a_torn_last_line_of_the_log_is_not_part_of_it(folder: Path) -> None:
    driver = open_cell(folder)
    pick(driver, Mover(site.cell()))
    seen = driver.observe()
    kill(folder)
    driver.close()
    log = folder / LOG_NAME
    whole = log.read_bytes()
    log.write_bytes(whole + b'{"kind": "ended", "command_id": "x", "rep')
    again = open_cell(folder)
    assert again.observe() == seen
    assert again.new_epoch() == 2
    assert all(r["kind"] for r in read_records(log)[0])
    again.close()


def test_a_damaged_log_is_an_error_that_names_the_line(folder: Path) -> None:
    driver = open_cell(folder)
    driver.shutdown()
    log = folder / LOG_NAME
    log.write_bytes(b"not json\n" + log.read_bytes())
    with pytest.raises(BackendError, match="line 1 is damaged"):
        open_cell(folder)


def test_other_pieces_restart_the_process_and_the_rest_stays(folder: Path) -> None:
    driver = open_cell(folder)
    pick(driver, Mover(site.cell()))
    seen = driver.observe()
    driver.close()
    spare = site.piece("spare", site.THIN, translation(-1.6, -1.65, 1.0))
    pieces = tuple(p for p in site.pieces() if p.id != "support-1")
    again = open_cell(folder, (*pieces, spare))
    now = again.observe()
    assert set(now.world_T_piece) == {*(p.id for p in pieces), "spare"}
    assert now.world_T_piece[THIN].distance_to_m(seen.world_T_piece[THIN]) < 1e-6
    assert now.robots[A].gripped == THIN
    again.close()


def test_a_fresh_start_forgets_and_keeps_the_old_log(folder: Path) -> None:
    driver = open_cell(folder)
    order = command("reach", B, Mover(site.cell()).through(B, (0.4, *site.HOME[1:])))
    driver.execute(order)
    driver.close()
    fresh = connect(folder, site.cell(), site.pieces(), is_fresh=True)
    assert fresh.status(order.command_id).state is CommandState.NEVER
    assert fresh.observe().robots[B].q_rad == pytest.approx(site.HOME, abs=1e-4)
    assert (folder / "cell-1.jsonl").exists()
    fresh.close()


def test_it_ends_by_itself_without_clients(folder: Path) -> None:
    driver = open_cell(folder, idle_s=0.3)
    pid = pid_of(folder)
    assert pid is not None
    driver.close()
    deadline_s = time.monotonic() + 20.0
    while is_alive(pid) and time.monotonic() < deadline_s:
        time.sleep(0.02)
    assert not is_alive(pid)
    assert not socket_path(folder).exists()


def test_a_deep_folder_gets_a_short_socket(folder: Path) -> None:
    deep = folder / ("d" * 60) / ("e" * 60)
    driver = open_cell(deep)
    assert len(os.fsencode(socket_path(deep))) < 108
    assert socket_path(deep).stat().st_mode & 0o077 == 0
    assert driver.new_epoch() == 1
    driver.shutdown()


def test_unallowed_contacts_are_in_the_extra_report(folder: Path) -> None:
    driver = open_cell(folder)
    mover = Mover(site.cell())
    into = grasp_pose(translation(0.3, -0.3, -0.17) @ site.TARGET)
    order = command("reach", A, mover.to_tcp(A, GRIPPER, over(into, 0.3), into))
    driver.execute(order)
    extra = driver.extra()
    assert {c["command_id"] for c in extra["contacts"]} == {CommandId(order.command_id)}
    assert Path(extra["physical_log"]) == (folder / LOG_NAME).resolve()
    assert extra["sim_time_s"] > 0.5
    kill(folder)
    driver.close()
    again = open_cell(folder)
    assert again.extra()["contacts"] == extra["contacts"]
    again.close()
