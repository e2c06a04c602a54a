// SPDX-License-Identifier: MIT
/* A component that shows the phoneme of the microphone while it is mounted: render it after a click. */
import { createRecogniser } from "phoneme-ear";
import { useEffect, useState } from "react";

export function Phoneme() {
  const [words, setWords] = useState("");
  useEffect(() => {
    let isMounted = true;
    const tell = (said) => isMounted && setWords(said);
    const onFrame = async ({ phoneme }) => tell((await started).model.phonemes[phoneme]);
    const started = createRecogniser({ onFrame, onEnd: (error) => tell(error.message) });
    started.catch((error) => tell(error.message));
    return () => {
      isMounted = false;
      started.then((recogniser) => recogniser.close()).catch(() => {}); // what failed to start needs no end
    };
  }, []);
  return <output>{words}</output>;
}
