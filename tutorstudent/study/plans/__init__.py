"""What a comparison runs: pipelines, environments, controls, and the plan made of them."""
