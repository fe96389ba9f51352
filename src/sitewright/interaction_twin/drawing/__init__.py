"""The one writer of pictures: the report, the command line and the page show what it draws."""
