"""`python -m gantline` is the same as the command `gantline`."""

from gantline.cli import main

if __name__ == "__main__":
    main()
