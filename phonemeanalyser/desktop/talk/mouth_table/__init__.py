"""The mouth table: shapes, times and visemes."""
