"""The plan of a lift into operations of drives, cuts and conditions."""
