"""What can be built and cannot well be meant: a file for each kind of thing that is doubtful."""
