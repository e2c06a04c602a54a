"""A head that moves: a face, and the performer that says what is heard with it."""

import numpy as np

from phonemeanalyser.desktop.talk.head.face_model import FaceModel
from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.gaze import Gaze, gaze_weights
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.performer import IdleMotion, Performer
from phonemeengine.mouth.table import MouthTable

LEAST_WEIGHT, LEAST_ANGLE = 0.002, 0.04
"""What is no change that anybody sees: of a weight, and of the head's pose in degrees."""


class MovingHead:
    """Shows on a face what a performer says.

    Attributes
    ----------
    face : that is moved.
    performer : says what is heard.
    pose : how the head is turned.
    revision : another number whenever it looks different.
    caption : what moves it, in words; empty where that goes without saying.
    notes : what it lacks for what is said, a sentence each.
    """

    def __init__(self, face: FaceModel, table: MouthTable, idle: IdleMotion) -> None:
        self.face = face
        self.performer = Performer(table, idle)
        self.pose = HeadPose()
        self.revision = 0
        self.caption = ""
        self.notes: tuple[str, ...] = ()
        self._seen: Float32Array = np.zeros(0, np.float32)
        self._gaze, self._looks = Gaze(idle.seed), idle.blinks

    def configure(self, table: MouthTable, idle: IdleMotion) -> None:
        """Go on with another table, or with other motion."""
        self.performer.configure(table, idle)
        self._looks = idle.blinks
        self.face.set_table(table)
        self._seen = np.zeros(0, np.float32)

    def move(self, now: float) -> None:
        """Show the face as it is at a time on the performer's clock."""
        if self.face.states is None:
            return
        _, weights, closure, pose = self.performer.at(now)
        eyes = gaze_weights(self._gaze.at(now), pose) if self._looks else {}
        look = np.array([*weights, closure, *eyes.values(), pose.yaw, pose.pitch, pose.roll], np.float32)
        if len(look) == len(self._seen):
            change = np.abs(look - self._seen)
            if change[:-3].max() < LEAST_WEIGHT and change[-3:].max() < LEAST_ANGLE:
                return
        self._seen, self.pose = look, pose
        self.face.move(weights)
        self.face.blink(closure)
        if eyes:
            self.face.look(eyes)
        self.revision += 1
