/* TLE493D-W2B6, Infineon: registers of generation 2, two-byte protocol (register, then data). */
#include "bus.h"
#include "chips.h"
#include "plan.h"

enum { RESULTS = 0x00, TEMP_AND_BZ = 0x05, DIAGNOSIS = 0x06, CONFIG = 0x10, MOD1 = 0x11, READ_COUNT };
enum { FUSES_RIGHT = 0x40, TEST_MODE = 0x10, CONVERTED = 0x0C };
enum { NO_INTERRUPT = 0x04, SHORT_RANGE = 0x08 };

static bool set(uint8_t address, uint8_t reg, uint8_t value)
{
    uint8_t out[2] = {reg, value};
    return bus_transfer(address, out, 2, 0, 0);
}

/* Low-power mode, 770 conversions a second; no interrupts on the clock line, which stretches the clock
 * while a conversion runs; the address stays. The highest bit makes the number of ones odd, those of the
 * update rate in MOD2 included, which are 0. */
static uint8_t mod1(uint8_t address)
{
    uint8_t type = address == 0x35 ? 0 : address == 0x22 ? 1 : address == 0x78 ? 2 : 3;
    uint8_t value = (uint8_t)(type << 5) | NO_INTERRUPT;
    return type == 0 || type == 3 ? value : value | 0x80;
}

bool chip_move(uint8_t from, uint8_t to)
{
    return from == to;
}

/* The lowest bit of CONFIG is the parity of registers 7 to 16; those before hold 33 ones after reset. */
bool chip_setup(uint8_t address)
{
    uint8_t config = TLE_SHORT ? SHORT_RANGE | 1 : 0;
    uint8_t reg = CONFIG, in[2];
    return set(address, MOD1, mod1(address)) && set(address, CONFIG, config) &&
           bus_transfer(address, &reg, 1, in, 2) && in[0] == config && in[1] == mod1(address);
}

/* Twelve bits: the upper eight, and four in the upper half of `low`. */
static int16_t twelve(uint8_t high, uint8_t low)
{
    return (int16_t)((uint16_t)high << 8 | (low & 0xF0)) >> 4;
}

/* False also where the chip lost power since chip_setup: its settings are gone. */
bool chip_read(uint8_t address, int16_t values[VALUES])
{
    uint8_t reg = RESULTS, in[READ_COUNT];
    if (!bus_transfer(address, &reg, 1, in, sizeof in) || in[MOD1] != mod1(address) ||
        (in[DIAGNOSIS] & (FUSES_RIGHT | TEST_MODE | CONVERTED)) != (FUSES_RIGHT | CONVERTED))
        return false;
    values[TEMPERATURE] = twelve(in[3], in[TEMP_AND_BZ] & 0xC0);
    values[X] = twelve(in[0], in[4]);
    values[Y] = twelve(in[1], (uint8_t)(in[4] << 4));
    values[Z] = twelve(in[2], (uint8_t)(in[TEMP_AND_BZ] << 4));
    return true;
}

bool chip_undervoltage(uint8_t address)
{
    (void)address; /* the chip resets itself, which chip_read sees */
    return false;
}

int16_t chip_decidegrees(int16_t temperature)
{
    return (int16_t)(250 + ((int32_t)temperature - 1180) * 12 / 5); /* 0.24 degrees a count */
}
