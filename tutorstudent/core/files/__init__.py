"""Files and plugins: from YAML to an engine, and from a run to its folder."""
