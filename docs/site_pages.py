"""Pages of the site that are made from the code: the command line, key by key.

`docs/conf.py` calls `write_generated_pages` before every build; the pages are not kept in git.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

GENERATED = Path("reference/generated")


def write_generated_pages(folder: Path) -> None:
    """Write every generated page into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "command_line.md").write_text(command_line_page())


@cache
def commands(module: str = "instobj.cli.app") -> dict[str, Any]:
    """Name → command of the program in a module, in the order of its `--help`; "bench rig" in a group."""
    from typer.main import get_command

    return dict(_visible(get_command(import_module(module).app)))


def _visible(group: Any) -> Iterator[tuple[str, Any]]:
    for name, command in group.commands.items():
        if hasattr(command, "commands"):
            yield from ((f"{name} {inner}", one) for inner, one in _visible(command))
        elif not command.hidden:
            yield name, command


def option_names(command: Any) -> set[str]:
    """Every spelling of a command's options, `--help` among them."""
    spellings = {"--help"}
    for parameter in command.params:
        spellings.update(parameter.opts, parameter.secondary_opts)
    return {name for name in spellings if name.startswith("-")}


def command_line_page() -> str:
    """The page that lists all commands with their arguments and options (MyST)."""
    blocks = ["# Command line", "As `instobj COMMAND --help` prints it."]
    for name, command in commands().items():
        blocks += [f"## {name}", _plain(command.help), *_tables(name, command)]
    return "\n\n".join(blocks) + "\n"


def _tables(name: str, command: Any) -> Iterator[str]:
    usage = " ".join(_usage(parameter) for parameter in command.params)
    yield f"```text\ninstobj {name} {usage}\n```"
    rows = [f"| {_spelling(p)} | {_plain(p.help)} | {_default(p)} |" for p in command.params]
    yield "\n".join(["| | | default |", "|---|---|---|", *rows])


def _usage(parameter: Any) -> str:
    if parameter.param_type_name == "argument":
        name = parameter.name.upper()
        return name if parameter.required else f"[{name}]"
    return f"[{parameter.opts[-1]}{f' {parameter.metavar}' if parameter.metavar else ''}]"


def _spelling(parameter: Any) -> str:
    if parameter.param_type_name == "argument":
        return f"`{parameter.name.upper()}`"
    names = [*parameter.opts, *parameter.secondary_opts]
    return ", ".join(f"`{name}`" for name in names)


def _default(parameter: Any) -> str:
    if parameter.required:
        return "needed"
    shown = parameter.default
    return "" if shown in (None, False, (), "") or callable(shown) else f"`{shown}`"


def _plain(text: str | None) -> str:
    return " ".join((text or "").split()).replace("|", r"\|")
