"""One module per code that gantline is compared with."""
