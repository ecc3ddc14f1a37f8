"""What a recording says of cranes, booms and hoists."""
