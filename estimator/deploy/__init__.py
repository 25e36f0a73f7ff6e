"""Estimators on the robot: ONNX export, and a runtime without torch."""
