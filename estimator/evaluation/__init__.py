"""Quality of estimators, next to what is possible at best."""
