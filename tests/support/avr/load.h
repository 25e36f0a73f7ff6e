/* A load over time, and an HX711 as Avia Semiconductor's data sheet describes it. */
#pragma once
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef struct {
    char data_port, clock_port;
    int data_bit, clock_bit, channel, points;
    double sps, ms[64], value[64];
    double next_ms, high_ms;
    bool started, clock_high, ready, down;
    int pulses, last_pulses, shown_bit;
    int32_t result;
} load_t;

static bool load_word(load_t *load, const char *word, FILE *file)
{
    if (!strcmp(word, "hx711"))
        return fscanf(file, " %c %d %c %d %lf", &load->data_port, &load->data_bit, &load->clock_port, &load->clock_bit,
                      &load->sps) == 5;
    if (!strcmp(word, "voltage"))
        return fscanf(file, "%d", &load->channel) == 1;
    return load->points < 64 && fscanf(file, "%lf %lf", &load->ms[load->points], &load->value[load->points]) == 2 &&
           ++load->points;
}

static double load_at(const load_t *load, double now_ms)
{
    int k = 0;
    while (k < load->points && load->ms[k] <= now_ms)
        k++;
    if (k == 0 || k == load->points)
        return load->points ? load->value[k ? k - 1 : 0] : 0;
    double share = (now_ms - load->ms[k - 1]) / (load->ms[k] - load->ms[k - 1]);
    return load->value[k - 1] + share * (load->value[k] - load->value[k - 1]);
}

/* Conversions that are due. The first one after a start takes four periods; one that nobody fetched is
 * replaced; none comes while bits are clocked out. The number of clock pulses chose input and gain. */
static void hx711_run(load_t *load, double now_ms)
{
    double period_ms = 1000 / load->sps;
    if (load->clock_high && now_ms - load->high_ms > 0.06)
        load->down = true;
    if (load->down)
        return;
    if (!load->started) {
        load->started = true;
        load->next_ms = now_ms + 4 * period_ms;
        load->last_pulses = 25;
        load->ready = false;
    }
    if (now_ms < load->next_ms)
        return;
    if (load->pulses == 0 || load->pulses >= 25) {
        double gain = load->last_pulses == 25 ? 128 : load->last_pulses == 27 ? 64 : 0;
        double steps = round(1e-3 * load_at(load, load->next_ms) * gain * 16777216);
        load->result = (int32_t)fmax(-8388608, fmin(8388607, steps));
        load->ready = true;
        load->pulses = 0;
    }
    load->next_ms += period_ms;
}

static void hx711_clock(load_t *load, bool high, double now_ms)
{
    hx711_run(load, now_ms);
    if (high == load->clock_high)
        return;
    load->clock_high = high;
    load->high_ms = now_ms;
    if (!high) {
        if (load->down)
            load->down = load->started = false, load->pulses = 0;
        return;
    }
    if (!load->ready && load->pulses == 0)
        return;
    load->pulses++;
    load->last_pulses = load->pulses;
    load->ready = false;
    load->shown_bit = load->pulses <= 24 ? load->result >> (24 - load->pulses) & 1 : 1;
}

static bool hx711_data(load_t *load, double now_ms)
{
    hx711_run(load, now_ms);
    if (load->ready)
        return false;
    return load->pulses == 0 || load->pulses > 24 || load->shown_bit;
}
