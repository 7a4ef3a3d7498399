"""New plugins from templates: `tutorstudent plugins new`. The templates themselves stand in `files`."""
