"""What a part can be: the roles, their life cycle, their options."""
