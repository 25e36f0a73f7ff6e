"""What a layout search leaves behind: files, figures, page."""
