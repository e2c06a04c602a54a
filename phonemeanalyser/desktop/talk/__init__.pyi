"""What the window needs of this page, and the module of each."""

from .model import TalkModel as TalkModel
from .page import Heads as Heads
from .page import TalkPage as TalkPage
from .parts import TalkParts as TalkParts
