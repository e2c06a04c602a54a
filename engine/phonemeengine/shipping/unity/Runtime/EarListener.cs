// SPDX-License-Identifier: MIT
using System;
using UnityEngine;

namespace PhonemeEar
{
    /// <summary>Recognises a microphone, or what the AudioSource beside it plays.</summary>
    [RequireComponent(typeof(AudioSource))]
    public abstract class EarListener : MonoBehaviour
    {
        private const int ClipSeconds = 1; // of a microphone: more than passes between two pictures

        [Tooltip("preset.bytes of this package, or another .ear file that was renamed to .bytes")]
        public TextAsset preset;

        [Tooltip("A mouth table that was shipped with the preset; empty for the usual one")]
        public string table = "";

        [Tooltip("Recognise a microphone instead of the AudioSource")]
        public bool microphone;

        [Tooltip("The name of the microphone; empty for the system's own")]
        public string device = "";

        private readonly FrameQueue queue = new FrameQueue();
        private EarModel model;
        private Ear ear;
        private AudioClip clip; // is read in Update: the microphone; on the web, which has no audio thread, what is played
        private int readTo;
        private float[] block = new float[0], mono = new float[0];
        private Frame[] frames = new Frame[0];
        private string trouble;

        /// <summary>The newest frame.</summary>
        public Frame Newest { get; private set; }

        /// <summary>The table that is meant where `table` is empty.</summary>
        protected abstract string UsualTable { get; }

        protected EarModel Model => model;
        protected int TableNumber { get; private set; }
        protected string TableName => string.IsNullOrEmpty(table) ? UsualTable : table;

        private string Device => string.IsNullOrEmpty(device) ? null : device;

        /// <summary>Take a frame, in the thread of the game.</summary>
        protected abstract void Hear(in Frame frame);

        /// <summary>What is opened with the preset, and what is closed with it.</summary>
        protected abstract void Begin();
        protected abstract void End();

        private void OnEnable() => AudioSettings.OnAudioConfigurationChanged += OnAudioChanged;

        private void OnDisable()
        {
            AudioSettings.OnAudioConfigurationChanged -= OnAudioChanged;
            Close();
        }

        private void OnAudioChanged(bool deviceWasChanged) => Close(); // the rate may be another one; Update opens again

        /// <summary>The preset is opened here, so that a component that was added at run time can be told which.</summary>
        protected virtual void Update()
        {
            try
            {
                if (model == null)
                    Open();
                if (clip != null)
                    ReadClip();
            }
            catch (EarException error)
            {
                trouble = error.Message;
            }
            while (queue.TryTake(out var frame))
            {
                Newest = frame;
                Hear(frame);
            }
            if (trouble == null)
                return;
            Debug.LogError($"{name}: {trouble}", this);
            trouble = null;
            enabled = false;
        }

        private void Open()
        {
            if (preset == null)
                throw new EarException("it has no preset; drag preset.bytes onto it");
            model = new EarModel(preset.bytes);
            TableNumber = model.FindTable(TableName);
            clip = FindClip();
            readTo = 0;
            AudioSettings.GetDSPBufferSize(out var length, out _);
            var rate = clip == null ? AudioSettings.outputSampleRate : clip.frequency;
            block = new float[clip == null ? 0 : rate / 100 * clip.channels];
            mono = new float[Math.Max(4 * length, rate / 100)];
            var opened = new Ear(model, rate);
            frames = new Frame[opened.MostFrames(mono.Length)];
            Begin();
            ear = opened; // the audio thread may begin
        }

        private void Close()
        {
            lock (queue) // the audio thread may be at it
            {
                ear?.Dispose();
                ear = null;
            }
            EndMicrophone();
            clip = null;
            End();
            model?.Dispose();
            model = null;
            while (queue.TryTake(out _)) { } // of the recogniser that is no more
            Newest = default;
        }

        private void ReadClip()
        {
            var position = Position();
            var n = block.Length / clip.channels;
            var waiting = (position - readTo + clip.samples) % clip.samples;
            if (waiting > clip.frequency * ClipSeconds)
                readTo = position; // it was wound to another place
            for (; waiting >= n && waiting <= clip.frequency * ClipSeconds; waiting -= n)
            {
                clip.GetData(block, readTo);
                readTo = (readTo + n) % clip.samples;
                Push(block, clip.channels);
            }
        }

        /// <summary>Unity calls this in the audio thread, with interleaved channels.</summary>
        private void OnAudioFilterRead(float[] data, int channels)
        {
            lock (queue) // free, but while the component is switched off
            {
                if (ear == null || microphone)
                    return;
                try
                {
                    Push(data, channels);
                }
                catch (EarException error)
                {
                    trouble = error.Message;
                }
            }
        }

        private void Push(float[] data, int channels)
        {
            var n = Math.Min(data.Length / channels, mono.Length);
            for (var k = 0; k < n; k++)
            {
                mono[k] = 0;
                for (var channel = 0; channel < channels; channel++)
                    mono[k] += data[k * channels + channel] / channels;
            }
            queue.Put(frames, ear.Push(mono, n, frames));
        }

#if UNITY_WEBGL && !UNITY_EDITOR
        private AudioClip FindClip()
        {
            if (microphone)
                throw new EarException("Unity has no microphone on the web; play a clip, or use the runtime's module for pages");
            return GetComponent<AudioSource>().clip;
        }

        private int Position() => GetComponent<AudioSource>().timeSamples;

        private void EndMicrophone() { }
#else
        private AudioClip FindClip()
        {
            if (!microphone)
                return null;
            if (Microphone.devices.Length == 0)
                throw new EarException("there is no microphone; connect one");
            var started = Microphone.Start(Device, true, ClipSeconds, AudioSettings.outputSampleRate);
            return started ? started : throw new EarException("the microphone cannot be opened; close other programs that may use it");
        }

        private int Position()
        {
            if (!Microphone.IsRecording(Device))
                throw new EarException("the microphone was taken away; connect it, and switch the component on again");
            return Microphone.GetPosition(Device);
        }

        private void EndMicrophone()
        {
            if (clip != null)
                Microphone.End(Device);
        }
#endif
    }
}
