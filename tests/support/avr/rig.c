/* An Arduino Mega with Hall sensors on its bus, simulated: rig FIRMWARE.elf WORLD
 *
 * Prints the name of a pseudo-terminal that carries the board's serial line, runs from the first byte that
 * comes there until the world ends (lines of WORLD, times in simulated ms):
 *   chip FAMILY FACTORY MUX MASK PORT BIT X Y Z T   T(MAG5273), M(LX90393) or E (TLE493D); its multiplexer's address and
 *                                         channel (0 0: none), port and bit of its supply (- 0: always on),
 *                                         field in mT and temperature in degrees C
 *                                         L (LSM6DS3), I (ICM-42688): acceleration in g, rates T, -T and 2 T degrees/s
 *   mux ADDRESS PORT BIT                  a TCA9548A and the port and bit of its reset line
 *   fault KIND CHIP FROM UNTIL            dead: does not answer; hang: holds the data line until it is clocked
 *                                         on, once; stuck: until it loses power; brownout: loses its registers
 *                                         at FROM; low: reports undervoltage at FROM; freeze: the board's clock stops
 *   hx711 DATA-PORT BIT CLOCK-PORT BIT SPS   an HX711 with a bridge
 *   voltage CHANNEL                       a force sensor on that analogue input
 *   load MS VALUE                         of the bridge (mV/V) or the sensor (mV) from then on, a line from
 *                                         one to the next
 *   avcc MILLIVOLT, end MS
 * Faults of the HX711 have chip -2: shorted (its data line is low), gone (it is not there).
 * Chips behave as their data sheets say: the address changes by its register until power is lost, results
 * stand in the registers only after a conversion, the range saturates, chips that answer together
 * give the AND of their bits.
 */
#define _GNU_SOURCE
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <pty.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#include "load.h"

#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_twi.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>

enum { TWBR = 0xB8, TWSR = 0xB9, TWCR = 0xBC, TWINT = 0x80, TWEN = 0x04, TCCR0B = 0x45, SDA = 1, SCL = 0, MOST = 64 };

typedef struct {
    char family;
    uint8_t factory, mux, mask;
    char port;
    int bit;
    double field[3], celsius;
    bool powered, selected, reading;
    uint8_t address, registers[256], pointer, count;
    uint16_t mlx[64];
    double ready_ms, up_ms;
} chip_t;

typedef struct { uint8_t address, channels; char port; int bit; bool selected; } mux_t;
typedef struct { char kind[12]; int chip; double from, until; bool done; } fault_t;

static avr_t *avr;
static chip_t chips[MOST];
static mux_t muxes[8];
static fault_t faults[16];
static int chip_count, mux_count, fault_count, holder = -1, clocks_left;
static double end_ms = 2000;
static avr_irq_t *to_twi, *sda_pin, *to_uart;
static avr_io_write_t write_twcr;
static void *twcr_param;
static bool scl_low, uart_full, address_sent;
static int terminal;
static load_t load;

static double now_ms(void) { return (double)avr->cycle / 16000.0; }

static bool faulty(const char *kind, int chip)
{
    for (int k = 0; k < fault_count; k++)
        if (!strcmp(faults[k].kind, kind) && faults[k].chip == chip && now_ms() >= faults[k].from && now_ms() < faults[k].until)
            return true;
    return false;
}

/* Whether a fault that happens once is due; not again afterwards. */
static bool happens(const char *kind, int chip)
{
    for (int k = 0; k < fault_count; k++)
        if (!strcmp(faults[k].kind, kind) && faults[k].chip == chip && now_ms() >= faults[k].from && !faults[k].done)
            return faults[k].done = true;
    return false;
}

static void hold_data(int chip, int clocks)
{
    holder = chip;
    clocks_left = clocks;
    avr_ioport_external_t external = {.name = 'D', .mask = 3, .value = holder < 0 ? 3 : 1};
    avr_ioctl(avr, AVR_IOCTL_IOPORT_SET_EXTERNAL('D'), &external);
    avr_raise_irq(sda_pin, holder < 0);
}

/* ---- chips */

/* TLE493D-W2B6 after power-up: interrupts on, and the parity of its settings wrong. */
static void reset_tle(chip_t *c)
{
    static const uint8_t from_six[] = {0x60, 0x80, 0x7F, 0x80, 0x7F, 0x80, 0x7F, 0x38, 0x38, 0x38, 0x01};
    memset(c->registers, 0, sizeof c->registers);
    memcpy(c->registers + 6, from_six, sizeof from_six);
    uint8_t type = c->factory == 0x35 ? 0 : c->factory == 0x22 ? 1 : c->factory == 0x78 ? 2 : 3;
    c->registers[0x11] = (uint8_t)(type << 5 | (type == 1 || type == 2 ? 0 : 0x80));
    c->registers[0x16] = 0xC9;
}

static void reset_chip(chip_t *c)
{
    memset(c->registers, 0, sizeof c->registers);
    memset(c->mlx, 0, sizeof c->mlx);
    c->address = c->factory;
    c->registers[0x0E] = 0x49, c->registers[0x0F] = 0x54, c->registers[0x18] = 0x10;
    if (c->family == 'E')
        reset_tle(c);
    if (c->family == 'L')
        c->registers[0x0F] = 0x69;
    if (c->family == 'I')
        c->registers[0x75] = 0x47;
    c->ready_ms = -1;
    c->up_ms = now_ms() + (c->family == 'T' ? 0.27 : 1.0);
    c->selected = false;
}

static void power(chip_t *c, bool on)
{
    if (on && !c->powered)
        reset_chip(c);
    if (!on && holder == c - chips)
        hold_data(-1, 0);
    c->powered = on;
}

static int16_t saturated(double counts)
{
    return (int16_t)fmax(-32768, fmin(32767, round(counts)));
}

static void put(uint8_t *at, int16_t value)
{
    at[0] = (uint8_t)((uint16_t)value >> 8);
    at[1] = (uint8_t)value;
}

/* Results of the TMAG5273: 32768 counts are the range; 60.1 counts a degree, 17508 at 25 degrees. */
static void convert_tmag(chip_t *c)
{
    uint8_t *r = c->registers, enabled = r[2] >> 4;
    bool running = (r[1] & 3) == 2;
    if (!running || c->ready_ms < 0 || now_ms() < c->ready_ms)
        return;
    double range[3] = {r[3] & 2 ? 80 : 40, r[3] & 2 ? 80 : 40, r[3] & 1 ? 80 : 40};
    for (int k = 0; k < 3; k++)
        put(r + 0x12 + 2 * k, enabled >> k & 1 ? saturated(c->field[k] / range[k] * 32768) : 0);
    put(r + 0x10, r[7] & 1 ? saturated(17508 + 60.1 * (c->celsius - 25)) : 0);
    r[0x18] |= 1;
}

static void written_tmag(chip_t *c, uint8_t reg, uint8_t value)
{
    if (reg == 0x0C) {
        if (value & 1)
            c->address = value >> 1;
    } else if (reg == 0x18 || reg == 0x1C) {
        c->registers[reg] &= (uint8_t)~value; /* ones clear */
    } else if (reg < 0x0C) {
        c->registers[reg] = value;
        int axes = 0;
        for (int k = 0; k < 3; k++)
            axes += c->registers[2] >> (4 + k) & 1;
        axes += c->registers[7] & 1;
        if (reg == 1 && (value & 3) == 2)
            c->ready_ms = now_ms() + 0.001 * (25 + 25.0 * axes * (1 << (c->registers[0] >> 2 & 7)));
    }
}

/* Results of the MLX90393 at OSR 2, filter 4: 0.150 uT a count at gain 7, more at others, Z 1.613 times. */
static void answer_mlx(chip_t *c)
{
    static const double ut[8] = {0.751, 0.601, 0.451, 0.376, 0.300, 0.250, 0.200, 0.150};
    uint8_t *r = c->registers, code = r[0xF0];
    bool ready = c->ready_ms >= 0 && now_ms() >= c->ready_ms && (code & 0xF0) == 0x40;
    r[0] = (uint8_t)((code & 0xF0) == 0x40 && !ready ? 0x10 : c->ready_ms >= 0 ? 0x80 : 0x00);
    if (!ready)
        return;
    double step = ut[c->mlx[0] >> 4 & 7] * (1 << (c->mlx[2] >> 5 & 3)) / 1e3;
    put(r + 1, (int16_t)(uint16_t)round(46244 + 45.2 * (c->celsius - 35)));
    for (int k = 0; k < 3; k++)
        put(r + 3 + 2 * k, saturated(c->field[k] / step / (k == 2 ? 1.613 : 1)));
}

static void written_mlx(chip_t *c, uint8_t value)
{
    uint8_t *r = c->registers;
    r[0xF0 + (c->count < 4 ? c->count : 3)] = value;
    if (c->count == 0 && value == 0xF0)
        c->ready_ms = -1;
    if (c->count == 0 && (value & 0xF0) == 0x10)
        c->ready_ms = now_ms() + 14.8;
    if (c->count == 3 && r[0xF0] == 0x60)
        c->mlx[value >> 2 & 63] = (uint16_t)(r[0xF1] << 8 | r[0xF2]);
}

static int ones(const uint8_t *at, int count)
{
    int found = 0;
    for (int k = 0; k < 8 * count; k++)
        found += at[k / 8] >> k % 8 & 1;
    return found;
}

/* Results of the TLE493D-W2B6, 12 bits: 7.7 counts a mT, 15.4 in its short range; 770 conversions a second
 * of 0.35 ms, during which the clock is held. Interrupts (MOD1 bit 2 clear) would pulse the clock line. */
static void convert_tle(chip_t *c)
{
    uint8_t *r = c->registers, settings[10];
    double phase = fmod(now_ms() - c->up_ms, 1.3);
    if (phase < 0.35 && (r[0x11] & 0x0C) == 0x04)
        avr->cycle += (avr_cycle_count_t)((0.35 - phase) * 16000);
    memcpy(settings, r + 7, 10);
    settings[6] &= 0x7F, settings[7] &= 0x3F, settings[8] &= 0x3F;
    uint8_t fuses[2] = {r[0x11], r[0x13] & 0xE0};
    bool converted = c->ready_ms >= 0 && now_ms() >= c->ready_ms;
    r[6] = (uint8_t)((ones(fuses, 2) & 1) << 6 | (ones(settings, 10) & 1) << 5 | (converted ? 0x0C : 0));
    if (!converted)
        return;
    int16_t b[3], t = (int16_t)(4 * lround(295 + (c->celsius - 25) / 0.96));
    for (int k = 0; k < 3; k++)
        b[k] = (int16_t)fmax(-2048, fmin(2047, rint(c->field[k] * (r[0x10] & 8 ? 15.4 : 7.7))));
    for (int k = 0; k < 3; k++)
        r[k] = (uint8_t)(b[k] >> 4);
    r[3] = (uint8_t)(t >> 4);
    r[4] = (uint8_t)((b[0] & 15) << 4 | (b[1] & 15));
    r[5] = (uint8_t)((t & 12) << 4 | (r[0x11] >> 5 & 3) << 4 | (b[2] & 15));
}

static void written_tle(chip_t *c, uint8_t reg, uint8_t value)
{
    static const uint8_t addresses[] = {0x35, 0x22, 0x78, 0x44};
    if (reg < 0x07 || (reg > 0x11 && reg != 0x13))
        return;
    c->registers[reg] = value;
    if (reg == 0x11) {
        c->address = addresses[value >> 5 & 3];
        c->ready_ms = now_ms() + 1.3;
    }
}

/* Results of the IMUs: nothing but one number while their modes are off. */
static void convert_imu(chip_t *c)
{
    uint8_t *r = c->registers;
    bool st = c->family == 'L', on = st ? r[0x10] >> 4 && r[0x11] >> 4 : (r[0x4E] & 0x0F) == 0x0F;
    static const double st_g[] = {2, 16, 4, 8}, st_rate[] = {245, 500, 1000, 2000};
    double g = st ? st_g[r[0x10] >> 2 & 3] : 16 / (double)(1 << (r[0x50] >> 5));
    double rate = st ? st_rate[r[0x11] >> 2 & 3] : 2000 / (double)(1 << (r[0x4F] >> 5));
    double per_g = st ? 1 / (0.000061 * g / 2) : 32768 / g, per_rate = st ? 1 / (0.00875 * rate / 250) : 16.4 * 2000 / rate;
    double rates[3] = {c->celsius, -c->celsius, 2 * c->celsius};
    for (int k = 0; k < 3; k++) {
        int16_t a = on ? saturated(c->field[k] * per_g) : st ? 0 : -32768, w = on ? saturated(rates[k] * per_rate) : st ? 0 : -32768;
        uint8_t *first = r + (st ? 0x22 : 0x1F) + 2 * k;
        put(first, st ? (int16_t)((uint16_t)w << 8 | (uint16_t)w >> 8) : a);
        put(first + 6, st ? (int16_t)((uint16_t)a << 8 | (uint16_t)a >> 8) : w);
    }
}

static void written(chip_t *c, uint8_t value)
{
    if (c->family == 'M')
        written_mlx(c, value);
    else if (c->count == 0)
        c->pointer = value;
    else if (c->family == 'E')
        written_tle(c, (uint8_t)((c->pointer & 0x1F) + c->count - 1), value);
    else if (c->family == 'L' || c->family == 'I')
        c->registers[(uint8_t)(c->pointer + c->count - 1)] = value;
    else
        written_tmag(c, (uint8_t)(c->pointer + c->count - 1), value);
    c->count++;
}

static uint8_t next_byte(chip_t *c)
{
    return c->registers[(uint8_t)((c->family == 'M' ? 0 : c->pointer) + c->count++)];
}

static bool reachable(const chip_t *c)
{
    if (!c->powered || now_ms() < c->up_ms || faulty("dead", (int)(c - chips)))
        return false;
    for (int k = 0; k < mux_count; k++)
        if (muxes[k].address == c->mux)
            return muxes[k].channels & c->mask;
    return c->mux == 0;
}

static void select_chip(chip_t *c, uint8_t address_and_direction)
{
    int number = (int)(c - chips);
    if (happens("brownout", number))
        reset_chip(c);
    if (happens("low", number))
        c->registers[0x1C] |= 1;
    c->selected = reachable(c) && c->address == address_and_direction >> 1;
    c->reading = address_and_direction & 1;
    c->count = 0;
    if (!c->selected || !c->reading)
        return;
    if (c->family == 'T')
        convert_tmag(c);
    else if (c->family == 'E')
        convert_tle(c);
    else if (c->family == 'M')
        answer_mlx(c);
    else
        convert_imu(c);
}

/* ---- load cell */

static void on_load_clock(struct avr_irq_t *irq, uint32_t value, void *param)
{
    hx711_clock(&load, value & 1, now_ms());
}

/* The converter's input, and the HX711's data line; without a chip the pull-up of the pin decides. */
static void drive_load(void)
{
    static int shown = -1;
    static double next_ms;
    if (load.channel >= 0 && now_ms() >= next_ms && (next_ms = now_ms() + 0.05))
        avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0 + load.channel),
                      (uint32_t)fmax(0, load_at(&load, now_ms())));
    if (!load.data_port)
        return;
    bool driven = !faulty("gone", -2);
    bool high = driven && hx711_data(&load, now_ms()) && !faulty("shorted", -2);
    int now = driven ? high : 2;
    if (now == shown)
        return;
    shown = now;
    uint8_t mask = (uint8_t)(1 << load.data_bit);
    avr_ioport_external_t external = {.name = load.data_port, .mask = driven ? mask : 0, .value = high ? mask : 0};
    avr_ioctl(avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(load.data_port), &external);
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(load.data_port), load.data_bit), !driven || high);
}

/* ---- bus */

static void reply(uint8_t message, uint8_t address, uint8_t data)
{
    avr_raise_irq(to_twi, avr_twi_irq_msg(message, address, data));
}

static void on_address(uint8_t address)
{
    bool answered = false;
    for (int k = 0; k < chip_count; k++) {
        select_chip(&chips[k], address);
        answered |= chips[k].selected;
    }
    for (int k = 0; k < mux_count; k++) {
        muxes[k].selected = muxes[k].address == address >> 1 && !(address & 1);
        answered |= muxes[k].selected;
    }
    if (answered)
        reply(TWI_COND_ACK, address, 1);
}

static void on_read(uint8_t address)
{
    uint8_t wired_and = 0xFF;
    for (int k = 0; k < chip_count; k++) {
        if (!chips[k].selected)
            continue;
        wired_and &= next_byte(&chips[k]);
        if (chips[k].count == 4 && happens("hang", k))
            hold_data(k, 5);
        if (chips[k].count == 4 && faulty("stuck", k))
            hold_data(k, 1000000);
    }
    reply(TWI_COND_READ, address, wired_and);
}

/* libsimavr 1.6 reports a written address as if it were data (0x28 and 0x30 in place of 0x18 and 0x20). */
static void on_status(struct avr_irq_t *irq, uint32_t value, void *param)
{
    if (address_sent && (value == 0x28 || value == 0x30))
        avr->data[TWSR] = (uint8_t)((avr->data[TWSR] & 7) | (value - 0x10));
    address_sent = false;
}

/* It takes no time for a byte either: nine clocks pass here, at the rate of the register TWBR. */
static void pass_byte(void)
{
    avr->cycle += 9u * (16u + 2u * avr->data[TWBR]);
}

static void on_bus(struct avr_irq_t *irq, uint32_t value, void *param)
{
    avr_twi_msg_irq_t message;
    message.u.v = value;
    uint8_t what = message.u.twi.msg, address = message.u.twi.addr;
    pass_byte();
    address_sent = what & TWI_COND_START;
    if (what & TWI_COND_STOP) {
        for (int k = 0; k < chip_count; k++)
            chips[k].selected = false;
    } else if (what & TWI_COND_START) {
        on_address(address);
    } else if (what & TWI_COND_WRITE) {
        bool taken = false;
        for (int k = 0; k < chip_count; k++)
            if (chips[k].selected) {
                written(&chips[k], message.u.twi.data);
                taken = true;
            }
        for (int k = 0; k < mux_count; k++)
            if (muxes[k].selected) {
                muxes[k].channels = message.u.twi.data;
                taken = true;
            }
        if (taken)
            reply(TWI_COND_ACK, address, 1);
    } else if (what & TWI_COND_READ) {
        on_read(address);
    }
}

/* While a chip holds the data line, the controller's actions do not end. */
static void on_twcr(avr_t *a, avr_io_addr_t addr, uint8_t value, void *param)
{
    if (holder >= 0 && value & TWEN)
        a->data[addr] = value;
    else
        write_twcr(a, addr, value, twcr_param);
    a->data[addr] &= (uint8_t)~TWINT; /* libsimavr 1.6 clears it only for interrupts; states come later */
}

/* ---- pins */

static void on_direction_d(struct avr_irq_t *irq, uint32_t value, void *param)
{
    bool low = value >> SCL & 1;
    if (!low && scl_low && holder >= 0 && --clocks_left == 0)
        hold_data(-1, 0);
    scl_low = low;
}

static void on_pin(struct avr_irq_t *irq, uint32_t value, void *param)
{
    char port = (char)(intptr_t)param;
    for (int k = 0; k < chip_count; k++)
        if (chips[k].port == port && chips[k].bit == (int)irq->irq)
            power(&chips[k], value & 1);
    for (int k = 0; k < mux_count; k++)
        if (muxes[k].port == port && muxes[k].bit == (int)irq->irq && !(value & 1)) {
            muxes[k].channels = 0;
            if (holder >= 0 && chips[holder].mux == muxes[k].address)
                hold_data(-1, 0);
        }
}

/* ---- serial line */

static void on_uart(struct avr_irq_t *irq, uint32_t value, void *param)
{
    uint8_t byte = (uint8_t)value;
    while (write(terminal, &byte, 1) < 0)
        usleep(200);
}

static void on_xon(struct avr_irq_t *irq, uint32_t value, void *param) { uart_full = false; }
static void on_xoff(struct avr_irq_t *irq, uint32_t value, void *param) { uart_full = true; }

static void poll_terminal(void)
{
    uint8_t byte;
    while (!uart_full && read(terminal, &byte, 1) == 1)
        avr_raise_irq(to_uart, byte);
}

/* ---- world */

static void read_world(const char *path)
{
    FILE *file = fopen(path, "r");
    char word[16];
    while (file && fscanf(file, "%15s", word) == 1) {
        if (!strcmp(word, "chip")) {
            chip_t *c = &chips[chip_count++];
            unsigned factory, mux, mask;
            if (fscanf(file, " %c %x %x %x %c %d %lf %lf %lf %lf", &c->family, &factory, &mux, &mask, &c->port,
                       &c->bit, &c->field[0], &c->field[1], &c->field[2], &c->celsius) != 10)
                exit(2);
            c->factory = (uint8_t)factory, c->mux = (uint8_t)mux, c->mask = (uint8_t)mask;
        } else if (!strcmp(word, "mux")) {
            mux_t *m = &muxes[mux_count++];
            unsigned address;
            if (fscanf(file, "%x %c %d", &address, &m->port, &m->bit) != 3)
                exit(2);
            m->address = (uint8_t)address;
        } else if (!strcmp(word, "fault")) {
            fault_t *f = &faults[fault_count++];
            if (fscanf(file, "%11s %d %lf %lf", f->kind, &f->chip, &f->from, &f->until) != 4)
                exit(2);
        } else if (!strcmp(word, "hx711") || !strcmp(word, "voltage") || !strcmp(word, "load")) {
            if (!load_word(&load, word, file))
                exit(2);
        } else if (!strcmp(word, "avcc")) {
            if (fscanf(file, "%u", &avr->avcc) != 1)
                exit(2);
        } else if (strcmp(word, "end") || fscanf(file, "%lf", &end_ms) != 1) {
            exit(2);
        }
    }
}

static void connect_all(void)
{
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_TWI_GETIRQ(0), TWI_IRQ_OUTPUT), on_bus, 0);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_TWI_GETIRQ(0), TWI_IRQ_STATUS), on_status, 0);
    to_twi = avr_io_getirq(avr, AVR_IOCTL_TWI_GETIRQ(0), TWI_IRQ_INPUT);
    for (char port = 'A'; port <= 'L'; port++)
        for (int bit = 0; bit < 8; bit++) {
            avr_irq_t *irq = avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(port), bit);
            if (irq)
                avr_irq_register_notify(irq, on_pin, (void *)(intptr_t)port);
        }
    if (load.data_port)
        avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(load.clock_port), load.clock_bit), on_load_clock, 0);
    sda_pin = avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), SDA);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), IOPORT_IRQ_DIRECTION_ALL), on_direction_d, 0);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), on_uart, 0);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XON), on_xon, 0);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XOFF), on_xoff, 0);
    to_uart = avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT);
    uint32_t flags = 0;
    avr_ioctl(avr, AVR_IOCTL_UART_GET_FLAGS('0'), &flags);
    flags &= ~(uint32_t)(AVR_UART_FLAG_STDIO | AVR_UART_FLAG_POLL_SLEEP);
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    write_twcr = avr->io[AVR_DATA_TO_IO(TWCR)].w.c;
    twcr_param = avr->io[AVR_DATA_TO_IO(TWCR)].w.param;
    avr->io[AVR_DATA_TO_IO(TWCR)].w.c = on_twcr;
}

/* Sleeping takes no time of ours. */
static void do_not_sleep(avr_t *a, avr_cycle_count_t cycles) {}

static void freeze_clock(void)
{
    avr_io_addr_t io = AVR_DATA_TO_IO(TCCR0B);
    avr->io[io].w.c(avr, TCCR0B, 0, avr->io[io].w.param);
}

int main(int count, char **words)
{
    elf_firmware_t firmware = {0};
    if (count != 3 || elf_read_firmware(words[1], &firmware))
        return 2;
    strcpy(firmware.mmcu, "atmega2560");
    firmware.frequency = 16000000;
    avr = avr_make_mcu_by_name("atmega2560");
    avr_init(avr);
    avr->vcc = avr->avcc = avr->aref = 5000;
    avr_load_firmware(avr, &firmware);
    load.channel = -1;
    read_world(words[2]);
    char name[64];
    int slave;
    if (openpty(&terminal, &slave, name, 0, 0))
        return 2;
    struct termios raw;
    tcgetattr(slave, &raw);
    cfmakeraw(&raw);
    tcsetattr(slave, TCSANOW, &raw);
    fcntl(terminal, F_SETFL, O_NONBLOCK);
    avr->sleep = do_not_sleep;
    connect_all();
    hold_data(-1, 0);
    for (int k = 0; k < chip_count; k++)
        power(&chips[k], chips[k].port == '-');
    puts(name);
    fflush(stdout);
    struct pollfd asked = {.fd = terminal, .events = POLLIN};
    poll(&asked, 1, -1); /* the reader is there: it asks for the channels */
    for (double polled_ms = 0; now_ms() < end_ms;) {
        int state = avr_run(avr);
        drive_load();
        if (state == cpu_Done || state == cpu_Crashed)
            return 3;
        if (now_ms() >= polled_ms) {
            polled_ms = now_ms() + 0.5;
            poll_terminal();
            if (happens("freeze", -1))
                freeze_clock();
        }
    }
    puts("end");
    fflush(stdout);
    while (getchar() != EOF) /* until the reader has read it all */
        ;
    return 0;
}
