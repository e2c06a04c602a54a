"""A mouth in a game loop: pygame draws it while the sound is played.

pip install pygame-ce
python examples/pygame_mouth.py SOUND
"""

import sys

import pygame

from phonemeengine import EngineError, Morpher, Sound, load_preset, load_table

SKIN, LIPS = (238, 200, 170), (120, 20, 30)


def draw(screen: pygame.Surface, weights: dict[str, float]) -> None:
    """Draw the mouth: how far the jaw is open, and how much the lips are rounded."""
    width = 240 - 140 * max(weights["mouthFunnel"], weights["mouthPucker"])
    height = 8 + 200 * weights["jawOpen"]
    screen.fill(SKIN)
    pygame.draw.ellipse(screen, LIPS, (200 - width / 2, 150 - height / 2, width, height))


def main(sound: str) -> None:
    """Play the sound once; without a sound card it passes silently."""
    pygame.display.init()
    screen, clock = pygame.display.set_mode((400, 300)), pygame.time.Clock()
    morpher, widest = Morpher(load_table("arkit"), seed=1), 0.0
    with Sound(sound, load_preset("learned")) as voice:
        voice.play()
        while voice.playing and not pygame.event.peek(pygame.QUIT):
            now = pygame.time.get_ticks() / 1000
            latest = voice.poll()
            morpher.add(now, latest.phoneme, latest.intensity)
            weights = dict(zip(morpher.movestates, map(float, morpher.weights(now)), strict=True))
            draw(screen, weights)
            pygame.display.flip()
            widest = max(widest, weights["jawOpen"])
            clock.tick(60)
    print(f"the jaw was open by {widest:.0%} at most")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except EngineError as error:
        sys.exit(str(error))
