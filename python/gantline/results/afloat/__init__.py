"""What a recording says of vessels, water, wind and moorings."""
