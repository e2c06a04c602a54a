// SPDX-License-Identifier: MIT
using System;
using UnityEngine;

namespace PhonemeEar
{
    /// <summary>Listens to the AudioSource beside it, which plays a line or a microphone.</summary>
    [RequireComponent(typeof(AudioSource))]
    public abstract class EarListener : MonoBehaviour
    {
        [Tooltip("preset.bytes of this package, or another .ear file that was renamed to .bytes")]
        public TextAsset preset;

        [Tooltip("A mouth table that was shipped with the preset")]
        public string table;

        [Tooltip("Play the microphone through the AudioSource, unheard")]
        public bool microphone;

        private readonly FrameQueue queue = new FrameQueue();
        private EarModel model;
        private Ear ear;
        private float[] mono = new float[0];
        private Frame[] frames = new Frame[0];
        private string trouble;

        /// <summary>What was heard last.</summary>
        public Frame Newest { get; private set; }

        protected EarModel Model => model;
        protected int TableNumber { get; private set; }

        protected virtual void OnEnable()
        {
            try
            {
                if (preset == null)
                    throw new EarException($"{name}: it has no preset; drag preset.bytes onto it");
                model = new EarModel(preset.bytes);
                TableNumber = model.FindTable(table);
                AudioSettings.GetDSPBufferSize(out var length, out _);
                mono = new float[4 * length];
                var opened = new Ear(model, AudioSettings.outputSampleRate);
                frames = new Frame[opened.MostFrames(mono.Length)];
                ear = opened; // the thread of the sound may begin
            }
            catch (EarException error)
            {
                Debug.LogError(error.Message, this);
                enabled = false;
                return;
            }
            if (microphone)
                ListenToMicrophone();
        }

        protected virtual void OnDisable()
        {
            lock (queue) // the thread of the sound may be listening
            {
                ear?.Dispose();
                ear = null;
            }
            model?.Dispose();
            model = null;
        }

        protected virtual void Update()
        {
            while (queue.TryTake(out var frame))
            {
                Newest = frame;
                Hear(frame);
            }
            if (trouble == null)
                return;
            Debug.LogError(trouble, this);
            enabled = false;
            trouble = null;
        }

        /// <summary>Take a frame, in the thread of the game.</summary>
        protected abstract void Hear(in Frame frame);

        private void ListenToMicrophone()
        {
            if (Microphone.devices.Length == 0)
            {
                Debug.LogError($"{name}: there is no microphone; connect one", this);
                return;
            }
            var source = GetComponent<AudioSource>();
            source.clip = Microphone.Start(null, true, 1, AudioSettings.outputSampleRate);
            source.loop = true;
            source.Play();
        }

        /// <summary>Unity calls this in the thread of the sound, with interleaved channels.</summary>
        private void OnAudioFilterRead(float[] data, int channels)
        {
            lock (queue) // free, but while the component is switched off
            {
                var n = Math.Min(data.Length / channels, mono.Length);
                if (ear == null)
                    return;
                for (var k = 0; k < n; k++)
                {
                    mono[k] = 0;
                    for (var channel = 0; channel < channels; channel++)
                        mono[k] += data[k * channels + channel] / channels;
                }
                try
                {
                    queue.Put(frames, ear.Push(mono, n, frames));
                }
                catch (EarException error)
                {
                    trouble = error.Message;
                }
            }
            if (microphone)
                Array.Clear(data, 0, data.Length); // nobody wants to hear himself
        }
    }
}
