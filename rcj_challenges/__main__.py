"""``python -m rcj_challenges`` is the command ``rcj-challenge``."""

from rcj_challenges.cli import main

if __name__ == "__main__":
    main()
