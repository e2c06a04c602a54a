"""Play a sound to a server, as a microphone or a voice would, and print what is said as it comes.

phonemeanalyser serve &
python examples/ask_server.py SOUND [ADDRESS]
"""

import asyncio
import sys

import aiohttp
import numpy as np
import soundfile


async def main(sound: str, address: str = "http://127.0.0.1:8765") -> None:
    """Print a line for each change; other programs need nothing of this one but its address."""
    samples, rate = soundfile.read(sound, dtype="float32", always_2d=True)
    async with aiohttp.ClientSession() as session, session.ws_connect(f"{address}/stream") as stream:
        await stream.send_json({"encoding": "f32", "rate": rate, "channels": samples.shape[1]})
        playing = asyncio.create_task(play(stream, samples, rate))
        last = ""
        async for message in stream:
            told = message.json()
            for k, phoneme in enumerate(told.get("phonemes", ())):
                if phoneme != last:
                    print(f"{told['time'] + k * 0.01:6.2f} s  {phoneme:<12} {told['visemes'][k]}", flush=True)
                last = phoneme
            if "error" in told:
                sys.exit(told["error"])
        await playing


async def play(stream: aiohttp.ClientWebSocketResponse, samples: np.ndarray, rate: int) -> None:
    """Send 20 ms at a time, when they would be heard."""
    for first in range(0, len(samples), rate // 50):
        await stream.send_bytes(samples[first : first + rate // 50].tobytes())
        await asyncio.sleep(0.02)
    await stream.send_json({"end": True})


if __name__ == "__main__":
    asyncio.run(main(*sys.argv[1:]))
