"""Whether the parts of a lift file fit together: a file for each of its sections."""
