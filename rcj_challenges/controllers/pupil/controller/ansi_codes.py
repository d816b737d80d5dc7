"""What colours a text in a terminal."""

from __future__ import annotations


class AnsiCodes:
    """Escape sequences (ECMA-48). A robot's log keeps them as they are printed."""

    RESET, BOLD, UNDERLINE, CLEAR_SCREEN = "\x1b[0m", "\x1b[1m", "\x1b[4m", "\x1b[2J"
    BLACK_FOREGROUND, RED_FOREGROUND, GREEN_FOREGROUND, YELLOW_FOREGROUND = (
        "\x1b[30m",
        "\x1b[31m",
        "\x1b[32m",
        "\x1b[33m",
    )
    BLUE_FOREGROUND, MAGENTA_FOREGROUND, CYAN_FOREGROUND, WHITE_FOREGROUND = (
        "\x1b[34m",
        "\x1b[35m",
        "\x1b[36m",
        "\x1b[37m",
    )
    BLACK_BACKGROUND, RED_BACKGROUND, GREEN_BACKGROUND, YELLOW_BACKGROUND = (
        "\x1b[40m",
        "\x1b[41m",
        "\x1b[42m",
        "\x1b[43m",
    )
    BLUE_BACKGROUND, MAGENTA_BACKGROUND, CYAN_BACKGROUND, WHITE_BACKGROUND = (
        "\x1b[44m",
        "\x1b[45m",
        "\x1b[46m",
        "\x1b[47m",
    )
