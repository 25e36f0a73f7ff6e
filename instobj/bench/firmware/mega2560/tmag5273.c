/* TMAG5273, Texas Instruments SLYS045: registers of section 6.6. */
#include "bus.h"
#include "chips.h"
#include "plan.h"

enum { DEVICE_CONFIG_1 = 0x00, DEVICE_CONFIG_2 = 0x01, SENSOR_CONFIG_1 = 0x02, SENSOR_CONFIG_2 = 0x03,
       T_CONFIG = 0x07, I2C_ADDRESS = 0x0C, MANUFACTURER_ID = 0x0E, T_RESULT = 0x10, CONV_STATUS = 0x18,
       DEVICE_STATUS = 0x1C };
enum { CONTINUOUS = 0x02, ALL_AXES = 0x70, POWER_ON_RESET = 0x10, VCC_UV = 0x01, ALL_ERRORS = 0x0F };

static bool set(uint8_t address, uint8_t reg, uint8_t value)
{
    uint8_t out[2] = {reg, value};
    return bus_transfer(address, out, 2, 0, 0);
}

bool chip_move(uint8_t from, uint8_t to)
{
    return set(from, I2C_ADDRESS, (uint8_t)(to << 1 | 1));
}

bool chip_setup(uint8_t address)
{
    uint8_t reg = MANUFACTURER_ID, id[2];
    return bus_transfer(address, &reg, 1, id, 2) && id[0] == 0x49 && id[1] == 0x54 &&
           set(address, DEVICE_CONFIG_1, TMAG_AVERAGING << 2) && set(address, SENSOR_CONFIG_1, ALL_AXES) &&
           set(address, SENSOR_CONFIG_2, TMAG_WIDE ? 0x03 : 0x00) && set(address, T_CONFIG, 1) &&
           set(address, CONV_STATUS, POWER_ON_RESET) && set(address, DEVICE_STATUS, ALL_ERRORS) &&
           set(address, DEVICE_CONFIG_2, CONTINUOUS);
}

/* False also where the chip lost power since chip_setup: its settings are gone. */
bool chip_read(uint8_t address, int16_t values[VALUES])
{
    uint8_t reg = T_RESULT, in[2 * VALUES + 1];
    if (!bus_transfer(address, &reg, 1, in, sizeof in) || in[2 * VALUES] & POWER_ON_RESET)
        return false;
    for (uint8_t k = 0; k < VALUES; k++)
        values[k] = (int16_t)((uint16_t)in[2 * k] << 8 | in[2 * k + 1]);
    return true;
}

bool chip_undervoltage(uint8_t address)
{
    uint8_t reg = DEVICE_STATUS, status;
    if (!bus_transfer(address, &reg, 1, &status, 1) || !(status & VCC_UV))
        return false;
    set(address, DEVICE_STATUS, VCC_UV);
    return true;
}

int16_t chip_decidegrees(int16_t temperature)
{
    /* 60.1 counts a degree, 17508 at 25 degrees; rounded */
    return (int16_t)((2505 + ((int32_t)temperature - 17508) * 1000 / 601) / 10);
}
