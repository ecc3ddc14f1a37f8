"""From the text of a lift file to a scenario, and back to lines of the text."""
