"""New plugins from templates: `tutorstudent plugins new`. The templates are in `files`."""
