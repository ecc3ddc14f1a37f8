"""The command line. Verbs load what they need when they run, so `gantline --help` loads nothing else."""

__all__ = ["CLOSED_PIPE", "INTERRUPTED", "main"]

#: Exit codes of an end by Ctrl-C, and since nobody reads on what is printed, as shells count them.
INTERRUPTED, CLOSED_PIPE = 130, 141
#: Objects made between two looks for those that nobody needs any more.
_BETWEEN_LOOKS = 50_000


def main() -> None:
    """Entry point of the command; Ctrl-C while it loads ends it without a word."""
    # This module loads nothing else, so that this comes before all that takes time.
    import gc
    import os
    import signal

    is_own = signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if is_own:
        # An exit and no exception, which what is being loaded may take for one of its own.
        signal.signal(signal.SIGINT, lambda *_: os._exit(INTERRUPTED))
    # Nearly all that a command makes it needs until its end: to look that through for what nobody needs any
    # more, as often as Python does by itself, takes about a twentieth of the time of a short command.
    gc.set_threshold(_BETWEEN_LOOKS)
    from gantline.cli.app import run_app

    if is_own:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        run_app()
    except KeyboardInterrupt:
        raise SystemExit(INTERRUPTED) from None
    except OSError as problem:
        # Trouble with a file has its message where the file is read or written; this is that of printing.
        if problem.filename is not None:
            raise
        from gantline.cli.messages import BAD_INPUT, complain

        # What has not gone out by now would be tried once more at the end, with a traceback.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        complain(f"standard output: cannot be written ({(problem.strerror or str(problem)).lower()})")
        raise SystemExit(BAD_INPUT) from None
