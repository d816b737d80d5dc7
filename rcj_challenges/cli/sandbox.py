"""What the terminal shows about the isolation of programs."""

from __future__ import annotations

from rcj_challenges.cli.stdio import print_lines


def require_layers(sandbox: str) -> None:
    """Print, on standard error, each layer of isolation that programs should get and do not get here.

    Raises:
        IsolationError: ``strict``, and layers are missing; or no such sandbox.
    """
    from rcj_challenges.programs.isolation import active_layers, dropped_layers
    from rcj_challenges.views.console import console_for

    active_layers(sandbox)
    for layer, why in dropped_layers(sandbox).items():
        print_lines(console_for(to_stderr=True), f"isolation: programs run without the layer {layer}: {why}")
