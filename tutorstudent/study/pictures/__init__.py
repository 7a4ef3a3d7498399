"""Pictures, as SVG and film."""
